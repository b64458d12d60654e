#pragma once
#include <optional>
#include <span>

namespace ringfilm::study {

/// How far a value goes with one factor, whatever the others do: its median where the factor is low and where it is
/// high; eq-swing.
struct Swing {
  double low = 0, high = 0;  ///< medians of the value [its unit]
};

/// Over the scenarios of a sample with the lowest and the highest third of the factor; of a choice (few values) its
/// first and its last. Scenarios in which one of the two is not finite are left out.
/// @param factor, values of the same scenarios. @returns nothing where fewer than 3 are left on a side, or the factor
/// does not vary
std::optional<Swing> swing_of(std::span<const double> factor, std::span<const double> values);

}  // namespace ringfilm::study
