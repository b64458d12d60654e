#include "ringfilm/study/comparison.hpp"

#include <algorithm>
#include <cmath>

#include "ringfilm/base/error.hpp"

namespace ringfilm::study {
namespace {

double cycle::CycleValues::*member_of(const std::string& quantity) {
  for (const cycle::CycleQuantity& candidate : cycle::cycle_quantities()) {
    if (candidate.name == quantity) return candidate.value;
  }
  throw InputError("a published value names the quantity \"" + quantity + "\", which no cycle value has",
                   "the names are those of `ringfilm run --json`");
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
    double closest = std::abs(row.computed - value.value);
    for (const LedgerEntry& entry : ledger) {
      for (const LedgerVariant& variant : entry.variants) {
        if (!variant.solved || std::abs(variant.values.*member - value.value) >= closest) continue;
        closest = std::abs(variant.values.*member - value.value);
        row.strongest_setting = variant.setting;
        row.with_strongest_setting = variant.values.*member;
      }
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace ringfilm::study
