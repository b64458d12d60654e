#include "ringfilm/study/ensemble/ledger.hpp"

#include <stdexcept>
#include <utility>

#include "ringfilm/cycle/setup/setup.hpp"
#include "ringfilm/study/ensemble/assumptions.hpp"

namespace ringfilm::study {
namespace {

cycle::Case values_alone(cycle::Case c) {
  c.output.crank_angles_deg.clear();
  c.output.fields = cycle::FieldOutput::kNone;
  return c;
}

}  // namespace

std::vector<LedgerEntry> assumptions(const cycle::Case& c) {
  std::vector<LedgerEntry> entries;
  for (const Assumption& assumption : assumptions_of(cycle::prepare(c))) entries.push_back(assumption.entry);
  return entries;
}

LedgerPlan ledger_plan(const cycle::Case& c) {
  LedgerPlan plan;
  const cycle::Case plain = values_alone(c);
  for (const Assumption& assumption : assumptions_of(cycle::prepare(c))) {
    plan.entries.push_back(assumption.entry);
    for (const Alternative& alternative : assumption.alternatives) {
      plan.entries.back().variants.push_back({alternative.setting, {}, true, ""});
      plan.cases.push_back(plain);
      alternative.apply(plan.cases.back());
    }
  }
  plan.cases.push_back(plain);
  return plan;
}

std::vector<LedgerEntry> ledger(LedgerPlan plan, std::span<const Ending> ended, const cycle::CycleValues& own) {
  if (ended.empty() || ended.size() != plan.cases.size()) {
    throw std::logic_error("a ledger needs an ending of each case of its plan");
  }
  const Ending& unchanged = ended.back();
  std::size_t i = 0;
  for (LedgerEntry& entry : plan.entries) {
    for (LedgerVariant& variant : entry.variants) {
      const Ending& ending = ended[i++];
      variant.values = ending.result.values;
      for (const cycle::CycleQuantity& quantity : cycle::cycle_quantities()) {
        if (!ending.is_solved() || !unchanged.is_solved()) break;
        double& value = variant.values.*quantity.value;
        if (value == unchanged.result.values.*quantity.value) value = own.*quantity.value;
      }
      variant.solved = ending.is_solved();
      variant.reason = ending.reason();
    }
  }
  return std::move(plan.entries);
}

std::vector<LedgerEntry> ledger(const cycle::Case& c, const Progress& progress, const BatchOptions& options) {
  LedgerPlan plan = ledger_plan(c);
  const std::vector<Ending> ended = endings(plan.cases, progress, options);
  return ledger(std::move(plan), ended, ended.back().result.values);
}

}  // namespace ringfilm::study
