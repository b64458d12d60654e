#pragma once
#include <optional>
#include <span>

#include "ringfilm/study/design/factor.hpp"

namespace ringfilm::study {

/// How far a value goes with one factor, whatever the others do: its median where the factor is low and where it is
/// high; eq-one-at-a-time.
struct OneAtATimeSensitivity {
  double low = 0, high = 0;  ///< medians of the value [its unit]
};

/// Which scenarios of a sample have a factor low and high.
enum class SensitivityEnds {
  kThirds,  ///< the lowest and the highest third of them
  kValues,  ///< those with the lowest and with the highest of the few values that it has
};

/// Values for listed numbers and for choices (the first and the last), thirds for all others.
SensitivityEnds sensitivity_ends(const Variation& variation);

/// Over the scenarios of a sample. Those in which one of the two is not finite are omitted.
/// @param factor, values of the same scenarios. @returns nothing where fewer than 3 are left on a side, or the factor
/// does not vary
std::optional<OneAtATimeSensitivity> one_at_a_time_sensitivity(std::span<const double> factor,
                                                               std::span<const double> values, SensitivityEnds ends);

}  // namespace ringfilm::study
