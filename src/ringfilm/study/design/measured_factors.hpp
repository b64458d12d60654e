#pragma once
#include <cstddef>
#include <vector>

#include "ringfilm/study/design/study.hpp"

namespace ringfilm::study {

/// Is an error of the measurement one for all bases that share their calibration, or another in each?
enum class Shared { kApart, kCommon };

struct MeasuredSharing {
  Shared calibration = Shared::kCommon;  ///< sharing of the error in the calibration of the lateral signal
  Shared reference = Shared::kCommon;    ///< sharing of the error in the reference values of the calibration's specimen
};

/// Adds the scatter that bases state in [contact.measured] as factors; eqs eq-measured-contact, eq-measured-zeta.
/// N, beta and sigma: normal about the base's own value with the deviations and correlations stated, cut off at 0, each
/// base for itself. The coefficient of boundary shear strength: times one factor for the scatter of its slope, one for
/// the calibration and one for its reference, normal about 1 with the relative deviation, cut off at 0; the last two
/// are common to the bases whose calibration has one name, if they are shared. A deviation that is absent or 0 adds
/// nothing. Rings of a pack that state the same have one pair of surfaces, others one each.
/// @param bases indices of study.bases
/// Throws InputError for a base that states no deviation, and where bases with one calibration differ in its relative
/// deviation by more than 2 %: one error cannot have two sizes.
void add_measured_factors(Study& study, const std::vector<std::size_t>& bases, const MeasuredSharing& sharing = {});

}  // namespace ringfilm::study
