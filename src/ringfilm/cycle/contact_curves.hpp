#pragma once
#include <string>
#include <vector>

#include "ringfilm/case/case.hpp"

/// The contact law of a case against the separation, next to other laws of the same surfaces: for pictures.
namespace ringfilm::cycle {

/// The same case with another contact law.
struct OtherContactLaw {
  std::string name, label;  ///< a stable word; in words
  Case of;
};
/// Those that the surfaces of the case allow; none of a measured pair, whose maps are not part of a case.
std::vector<OtherContactLaw> other_contact_laws(const Case& c);

/// Lists over the separation.
struct ContactCurves {
  struct Law {
    std::string name, label;
  };
  std::vector<double> separation;  ///< from 0 to kLambdaOfCurves times the roughness; empty: no contact [m]
  std::vector<Law> laws;           ///< that of the case first
  std::vector<double> pressure;    ///< of each law at each separation [Pa]
  /// The same of the standard deviation of ln p by what was measured: regions and relative positions of a measured
  /// pair, regions of N, beta and sigma; NaN where none is known [-].
  std::vector<double> log_deviation;
  std::vector<double> real_area;  ///< of the law of the case [-]
  /// Flow factors of the case or of the file of its law; empty: smooth walls [-].
  std::vector<double> phi_x, phi_y, phi_s;
};
inline constexpr double kLambdaOfCurves = 4;
inline constexpr int kPlacesOfCurves = 81;

/// Of a ring's case. Throws as asperity_contact().
ContactCurves contact_curves(const Case& c);

}  // namespace ringfilm::cycle
