#include "ringfilm/surface/topography/preparation.hpp"

#include "ringfilm/base/error.hpp"

namespace ringfilm::surface {

std::vector<std::string> Prepared::lines() const {
  std::vector<std::string> lines = {"form removed: " + form.text};
  for (const FilterApplied& filter : filters) lines.push_back(filter.text);
  if (filters.empty()) lines.push_back("no filter");
  return lines;
}

std::string Prepared::filter_text() const {
  std::string text;
  for (const FilterApplied& filter : filters) text += (text.empty() ? "" : "; ") + filter.text;
  return text.empty() ? "none" : text;
}

Prepared prepare(HeightMap& map, const Preparation& preparation) {
  const auto &shortest = preparation.short_cutoff_m, &longest = preparation.long_cutoff_m;
  if (shortest && longest && !(*shortest < *longest)) {
    throw InputError(
        "the short cut-off of " + length_text(*shortest) + " is not below the long one of " + length_text(*longest),
        "the short one removes what is finer, the long one what is coarser");
  }
  Prepared prepared;
  prepared.form = remove_form(map, preparation.form);
  const auto apply = [&](const std::optional<double>& cutoff, FilterSide side) {
    if (cutoff) prepared.filters.push_back(apply_filter(map, {preparation.filter, side, *cutoff}));
  };
  apply(shortest, FilterSide::short_cutoff);
  apply(longest, FilterSide::long_cutoff);
  return prepared;
}

}  // namespace ringfilm::surface
