#pragma once
#include <string>
#include <vector>

#include "ringfilm/cycle/result/result.hpp"

/// Wear of a rigid profile on a rough flat without oil, pressed with a load and slid: the integration of wear with
/// closed forms to compare with (verification/archard1953_dry_wear).
namespace ringfilm::study {

/// A profile that wears without oil.
struct DryWear {
  std::string profile;  ///< one of dry_wear_profiles()
  int cells = 0;
  double roughness = 0;      ///< sigma [m]
  double width = 0;          ///< [m]
  double load = 0;           ///< per width [N/m]
  double coefficient = 0;    ///< k [m2/N]
  double sliding = 0;        ///< length [m]
  double shape = 0;          ///< parabola: radius [m]; roof: slope [-]; wave: amplitude, of four waves [m]
  double largest_depth = 0;  ///< largest depth worn in a jump [m]
};

/// "flat", "parabola", "roof", "wave".
const std::vector<std::string>& dry_wear_profiles();

/// What a profile has lost: largest_worn_depth, depth_difference (largest less least), worn_area, amplitude_left (of a
/// wave, over the initial one), sliding_exponent (of the largest depth over the sliding length).
const std::vector<cycle::Quantity>& dry_wear_quantities();

/// @param quantity one of dry_wear_quantities() @returns [SI]
double dry_wear_value(const DryWear& input, const std::string& quantity);

}  // namespace ringfilm::study
