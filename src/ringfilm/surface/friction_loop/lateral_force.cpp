#include "ringfilm/surface/friction_loop/lateral_force.hpp"

#include <algorithm>
#include <boost/math/special_functions/pow.hpp>
#include <cmath>
#include <limits>
#include <map>

#include "ringfilm/base/error.hpp"

namespace ringfilm::surface {
namespace {

constexpr double kConfidence = 0.95;

/// What a calibration with lines is made on.
const std::map<CalibrationMethod, std::string> kReference{{CalibrationMethod::kSilicon, "silicon"},
                                                          {CalibrationMethod::kWedge, "a facet"}};

/// Degrees of freedom of a sum of variances after Welch and Satterthwaite; a share without scatter of its own has
/// infinitely many.
double joint_freedom(const ShearStrength& s, double of_slope, double of_calibration) {
  const double total = boost::math::pow<2>(s.deviation());
  const double shares =
      boost::math::pow<4>(s.slope_deviation) / of_slope + boost::math::pow<4>(s.calibration_deviation) / of_calibration;
  return shares > 0 ? boost::math::pow<2>(total) / shares : std::numeric_limits<double>::infinity();
}

/// A measurement cannot be its own reference. Two measurements with noise never give the same line to the last digit.
void check_apart(const FrictionSample& sample, const Calibration& calibration) {
  for (const LineFit& line : calibration.lines) {
    if (line.points != sample.line.points || line.slope != sample.line.slope || line.offset != sample.line.offset)
      continue;
    throw InputError("the sample " + sample.name + " and the calibration on " + kReference.at(calibration.method) +
                         " have the same friction-load line: it is calibrated on itself",
                     "use loops of another surface for one of them");
  }
}

ShearStrength shear_strength(const FrictionSample& sample, const Calibration& calibration) {
  if (sample.load_unit != calibration.load_unit) {
    throw InputError("the loads of " + sample.name + " and those of the calibration are not in one kind of unit",
                     "both in volts of the normal signal, or both in newtons");
  }
  if (!(sample.line.slope > 0)) {
    throw InputError("the friction on " + sample.name + " does not rise with load",
                     "are trace and retrace exchanged, or the loads of the wrong sign?");
  }
  check_apart(sample, calibration);
  ShearStrength s;
  s.sample = sample.name;
  s.zeta = calibration.psi * sample.line.slope;
  s.slope_deviation = calibration.psi * sample.line.slope_deviation;
  s.calibration_deviation = calibration.measurement_deviation * sample.line.slope;
  s.reference_deviation = calibration.reference_deviation * sample.line.slope;
  const double freedom = joint_freedom(s, sample.line.degrees_of_freedom(), calibration.degrees_of_freedom);
  const double half_width = coverage_factor(kConfidence, freedom) * s.deviation();
  s.low = std::max(0.0, s.zeta - half_width);
  s.high = s.zeta + half_width;
  return s;
}

}  // namespace

double ShearStrength::deviation() const {
  return std::hypot(slope_deviation, calibration_deviation, reference_deviation);
}

double ShearStrengths::correlation(std::size_t i, std::size_t j) const {
  const std::size_t n = samples.size();
  const double scale = std::sqrt(covariance[i * n + i] * covariance[j * n + j]);
  return scale > 0 ? covariance[i * n + j] / scale : (i == j ? 1.0 : 0.0);
}

ShearStrengths boundary_shear_strengths(const std::vector<FrictionSample>& samples, const Calibration& calibration) {
  ShearStrengths result;
  for (const FrictionSample& sample : samples) result.samples.push_back(shear_strength(sample, calibration));
  const double common = boost::math::pow<2>(calibration.deviation());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    for (std::size_t j = 0; j < samples.size(); ++j) {
      const double shared = common * samples[i].line.slope * samples[j].line.slope;
      result.covariance.push_back(shared + (i == j ? boost::math::pow<2>(result.samples[i].slope_deviation) : 0.0));
    }
  }
  return result;
}

}  // namespace ringfilm::surface
