#include "ringfilm/study/ledger.hpp"

#include "ringfilm/cycle/simulate.hpp"
#include "ringfilm/study/assumptions.hpp"

namespace ringfilm::study {
namespace {

LedgerVariant solved_variant(cycle::Case c, const Alternative& alternative) {
  LedgerVariant variant;
  variant.setting = alternative.setting;
  alternative.apply(c);
  c.output.crank_angles_deg.clear();
  c.output.fields = cycle::FieldsWanted::kNone;
  try {
    variant.values = cycle::simulate(cycle::prepare(c)).values;
  } catch (const cycle::StoppedCycle& stopped) {
    variant.solved = false;
    variant.values = stopped.result.values;
    variant.reason = stopped.what();
  } catch (const InputError& refused) {
    variant.solved = false;
    variant.reason = refused.what();
  }
  return variant;
}

}  // namespace

std::vector<LedgerEntry> assumptions(const cycle::Case& c) {
  std::vector<LedgerEntry> entries;
  for (const Assumption& assumption : assumptions_of(cycle::prepare(c))) entries.push_back(assumption.entry);
  return entries;
}

std::vector<LedgerEntry> ledger(const cycle::Case& c, const Progress& progress) {
  const std::vector<Assumption> all = assumptions_of(cycle::prepare(c));
  int total = 0;
  for (const Assumption& assumption : all) total += static_cast<int>(assumption.alternatives.size());
  int done = 0;
  std::vector<LedgerEntry> entries;
  for (const Assumption& assumption : all) {
    entries.push_back(assumption.entry);
    for (const Alternative& alternative : assumption.alternatives) {
      entries.back().variants.push_back(solved_variant(c, alternative));
      if (progress) progress(++done, total);
    }
  }
  return entries;
}

}  // namespace ringfilm::study
