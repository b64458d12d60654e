#pragma once
#include <string>
#include <tuple>
#include <vector>

#include "ringfilm/base/members.hpp"
#include "ringfilm/case/case.hpp"

/// The contact law of a case against the separation, next to other laws of the same surfaces: for pictures.
namespace ringfilm::cycle {

/// A case that differs from another one only in its contact law.
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
  std::vector<Law> laws;           ///< contact laws, that of the case first
  std::vector<double> pressure;    ///< pressure of each law at each separation [Pa]
  /// Standard deviation of ln p for each law at each separation, by the spread of measurements: regions and relative
  /// positions of a measured pair, regions of N, beta and sigma; NaN where it is not known [-].
  std::vector<double> log_deviation;
  /// Real area of contact over the nominal one, by the law of the case, at each separation [-]
  std::vector<double> real_area;
  /// Flow factors of the case or of the file of its law; empty: smooth walls [-].
  std::vector<double> phi_x, phi_y, phi_s;
};

/// The words of a law, as all outputs have them.
constexpr auto members(const ContactCurves::Law*) {
  using L = ContactCurves::Law;
  return std::tuple{Member{"name", "", "contact law, that of the case first", &L::name},
                    Member{"label", "", "the same in words", &L::label}};
}

/// The curves of each law, as all outputs have them.
constexpr auto curves_of_laws() {
  using C = ContactCurves;
  return std::tuple{Member{"pressure", "Pa", "contact pressure of the law", &C::pressure, "p_a", "eq-asperity-load"},
                    Member{"log_deviation", "1",
                           "standard deviation of the logarithm of that pressure by what was measured, NaN: not known",
                           &C::log_deviation, "s(ln p)", "eq-law-band"}};
}

/// The curves of the case alone, as all outputs have them.
constexpr auto members(const ContactCurves*) {
  using C = ContactCurves;
  return std::tuple{
      Member{"real_area", "1", "real contact area over the nominal one, law of the case", &C::real_area, "A"},
      Member{"phi_x", "1", "pressure flow factor along the motion", &C::phi_x, "phi_x", "eq-average-flow"},
      Member{"phi_y", "1", "pressure flow factor across the motion", &C::phi_y, "phi_y", "eq-average-flow"},
      Member{"phi_s", "1", "shear flow factor, first surface at rest", &C::phi_s, "phi_s", "eq-average-flow"}};
}

inline constexpr double kLambdaOfCurves = 4;
inline constexpr int kPlacesOfCurves = 81;

/// Contact curves of the case of a ring. Throws as asperity_contact().
ContactCurves contact_curves(const Case& c);

}  // namespace ringfilm::cycle
