#pragma once
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "ringfilm/base/members.hpp"
#include "ringfilm/case/case.hpp"
#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/study/ensemble/batch.hpp"

/// The assumption ledger: what a cycle takes for granted, and what it would change to take something else.
namespace ringfilm::study {

/// One other choice for an assumption, run through the same solver.
struct LedgerVariant {
  std::string setting;        ///< as one would write it, e.g. "film.cavitation = \"mass-conserving\""
  cycle::CycleValues values;  ///< values of the run with this setting alone changed; NaN if not solved
  bool solved = true;         ///< did its integration reach its end?
  std::string reason;         ///< why not, if not solved
};

/// The members of a variant but its values, as all outputs have them.
constexpr auto members(const LedgerVariant*) {
  return std::tuple{Member{"setting", "", "the one setting that differs", &LedgerVariant::setting},
                    Member{"solved", "1", "1 where the cycle was solved", &LedgerVariant::solved},
                    Member{"reason", "", "why it was not solved", &LedgerVariant::reason}};
}

/// One simplification or unstated input.
struct LedgerEntry {
  std::string topic;                    ///< stable word, e.g. "oil-supply"
  std::string statement;                ///< what is assumed in this very case, a sentence with its figures
  std::string consequence;              ///< what it is known or expected to do; empty if the variants show it
  std::string source;                   ///< where the decision is argued, e.g. "docs/theory/assumptions.md#oil-supply"
  bool can_be_lifted = false;           ///< does this program offer another choice?
  std::vector<LedgerVariant> variants;  ///< empty if it cannot be lifted, or only by a case of its own, or not computed
};

/// The members of an entry but its variants, as all outputs have them.
constexpr auto members(const LedgerEntry*) {
  using L = LedgerEntry;
  return std::tuple{Member{"topic", "", "stable word for the assumption", &L::topic},
                    Member{"statement", "", "what is assumed", &L::statement},
                    Member{"consequence", "", "what it is known to do", &L::consequence},
                    Member{"source", "", "where it is argued", &L::source},
                    Member{"can_be_lifted", "1", "1 where the program offers another choice", &L::can_be_lifted}};
}

/// The simplifications active in `c`, without running anything.
std::vector<LedgerEntry> assumptions(const cycle::Case& c);

/// A ledger whose variants are still to be run.
struct LedgerPlan {
  std::vector<LedgerEntry> entries;  ///< variants with their settings alone
  std::vector<cycle::Case> cases;    ///< those of all variants, entry by entry, and at last the case itself
};
LedgerPlan ledger_plan(const cycle::Case& c);  ///< which choices can be lifted

/// The ledger of a plan whose cases ended like this, in their order. @param own values of the case as it is reported; a
/// value that a setting does not move, bit by bit among the cases of the plan, is that one. Throws std::logic_error if
/// there are not as many endings as cases
std::vector<LedgerEntry> ledger(LedgerPlan plan, std::span<const Ending> ended, const cycle::CycleValues& own);

/// The assumptions of `c` with every variant run that this program can run, beside the case itself run like them.
std::vector<LedgerEntry> ledger(const cycle::Case& c, const Progress& progress = {}, const BatchOptions& options = {});

}  // namespace ringfilm::study
