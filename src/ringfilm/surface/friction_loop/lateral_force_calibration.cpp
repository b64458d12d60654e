#include "ringfilm/surface/friction_loop/lateral_force_calibration.hpp"

#include <boost/math/special_functions/pow.hpp>
#include <cmath>
#include <limits>

#include "ringfilm/base/error.hpp"

namespace ringfilm::surface {
namespace {

double relative(const Uncertain& u) { return u.deviation / u.value; }

void check_shape(const Lever& lever) {
  if (lever.shape == LeverShape::kRectangular) return;
  throw InputError("the formulas of bending and torsion hold for rectangular levers; this one is V-shaped",
                   "calibrate it on silicon or on the slopes of a grating");
}

void check_positive(const Uncertain& u, const std::string& name) {
  if (std::isfinite(u.value) && u.value > 0 && std::isfinite(u.deviation) && u.deviation >= 0) return;
  throw InputError("the " + name + " is not a number above zero with a standard deviation from zero on",
                   "lever data come from its maker or from a microscope");
}

void check_lever(const Lever& lever) {
  check_shape(lever);
  check_positive(lever.length_m, "length of the lever");
  check_positive(lever.tip_height_m, "height of the tip");
  check_positive(lever.poissons_ratio, "Poisson's ratio of the lever");
  check_positive(lever.sensitivity_ratio, "ratio of the photodiode's sensitivities");
}

void check_section(const Lever& lever) {
  check_positive(lever.youngs_modulus_Pa, "Young's modulus of the lever");
  check_positive(lever.width_m, "width of the lever");
  check_positive(lever.thickness_m, "thickness of the lever");
}

double rigidity(const Lever& lever) {
  return lever.youngs_modulus_Pa.value * lever.width_m.value * std::pow(lever.thickness_m.value, 3);
}

}  // namespace

double Calibration::deviation() const { return std::hypot(measurement_deviation, reference_deviation); }

std::string name_of(CalibrationMethod method) {
  switch (method) {
    case CalibrationMethod::kSilicon:
      return "silicon";
    case CalibrationMethod::kGeometry:
      return "geometry";
    case CalibrationMethod::kWedge:
      return "wedge";
  }
  throw std::logic_error("a method of calibration without a name");
}

Calibration calibrate_on_silicon(const LineFit& silicon, LoadUnit load_unit, Uncertain reference) {
  check_positive(reference, "coefficient of friction of silicon");
  if (!(silicon.slope > 0)) {
    throw InputError("the friction on silicon does not rise with load",
                     "are trace and retrace exchanged, or the loads of the wrong sign?");
  }
  const double psi = reference.value / silicon.slope;
  return {CalibrationMethod::kSilicon,
          load_unit,
          psi,
          psi * silicon.slope_deviation / silicon.slope,
          psi * relative(reference),
          silicon.degrees_of_freedom(),
          {silicon}};
}

double normal_stiffness(const Lever& lever) {
  check_lever(lever);
  check_section(lever);
  return rigidity(lever) / (4 * std::pow(lever.length_m.value, 3));
}

double torsional_stiffness(const Lever& lever) {
  check_lever(lever);
  check_section(lever);
  const double shear = rigidity(lever) / (2 * (1 + lever.poissons_ratio.value));
  return shear / (3 * lever.length_m.value * boost::math::pow<2>(lever.tip_height_m.value));
}

Calibration calibrate_by_geometry(const Lever& lever, LoadUnit load_unit) {
  check_lever(lever);
  const double length = lever.length_m.value, height = lever.tip_height_m.value;
  const double of_poisson = lever.poissons_ratio.deviation / (1 + lever.poissons_ratio.value);
  double psi = 0, variance = boost::math::pow<2>(of_poisson) + boost::math::pow<2>(relative(lever.tip_height_m));
  if (load_unit == LoadUnit::kVolt) {
    psi = length / height * lever.sensitivity_ratio.value / (1 + lever.poissons_ratio.value);
    variance += boost::math::pow<2>(relative(lever.length_m)) + boost::math::pow<2>(relative(lever.sensitivity_ratio));
  } else {
    check_section(lever);
    check_positive(lever.torsional_sensitivity_V_per_m, "torsional sensitivity of the photodiode");
    psi = 1.5 * height / length * torsional_stiffness(lever) / lever.torsional_sensitivity_V_per_m.value;
    variance += boost::math::pow<2>(2 * relative(lever.length_m)) +
                boost::math::pow<2>(3 * relative(lever.thickness_m)) + boost::math::pow<2>(relative(lever.width_m)) +
                boost::math::pow<2>(relative(lever.youngs_modulus_Pa)) +
                boost::math::pow<2>(relative(lever.torsional_sensitivity_V_per_m));
  }
  return {CalibrationMethod::kGeometry, load_unit, psi,
          psi * std::sqrt(variance),    0,         std::numeric_limits<double>::infinity()};
}

}  // namespace ringfilm::surface
