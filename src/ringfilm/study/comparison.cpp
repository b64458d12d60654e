#include "ringfilm/study/comparison.hpp"

#include <algorithm>
#include <cmath>

#include "ringfilm/base/error.hpp"

namespace ringfilm::study {
namespace {

/// Closer than this, a result agrees with a publication that prints two or three digits: nothing is left to explain.
constexpr double kAgrees = 0.01;

double cycle::CycleValues::*member_of(const std::string& quantity) {
  if (const auto found = cycle::cycle_quantity_index(quantity)) return cycle::cycle_quantities()[*found].value;
  throw InputError("a published value names the quantity \"" + quantity + "\", which no cycle value has",
                   "the names are those of `ringfilm run --json`");
}

/// Names the variant that comes closer to the published value than all others and the result itself.
void explain(ComparisonRow& row, double cycle::CycleValues::*member, const std::vector<LedgerEntry>& ledger) {
  double closest = std::abs(row.computed - row.published.value);
  for (const LedgerEntry& entry : ledger) {
    for (const LedgerVariant& variant : entry.variants) {
      const double away = std::abs(variant.values.*member - row.published.value);
      if (!variant.solved || !(away < closest)) continue;
      closest = away;
      row.strongest_setting = variant.setting;
      row.with_strongest_setting = variant.values.*member;
    }
  }
}

}  // namespace

std::vector<ComparisonRow> compare(const cycle::CycleResult& result, const std::vector<PublishedValue>& published,
                                   const std::vector<LedgerEntry>& ledger) {
  std::vector<ComparisonRow> rows;
  for (const PublishedValue& value : published) {
    const auto member = member_of(value.quantity);
    ComparisonRow row;
    row.published = value;
    row.computed = result.values.*member;
    row.deviation = (row.computed - value.value) / value.value;
    if (std::abs(row.deviation) > kAgrees) explain(row, member, ledger);
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace ringfilm::study
