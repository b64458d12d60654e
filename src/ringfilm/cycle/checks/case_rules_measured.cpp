#include "ringfilm/cycle/checks/case_rules_measured.hpp"

#include <cmath>
#include <string>

#include "ringfilm/cycle/checks/case_rules.hpp"

namespace ringfilm::cycle {
namespace {

using Breaches = std::vector<RuleBreach>;

const std::string kSection = "contact.measured.";

void refuse(const std::string& key, const std::string& predicate, const std::string& remedy, Breaches& breaches) {
  breaches.push_back({kSection + key, kSection + key + " " + predicate, remedy});
}

void check_lengths(const MeasuredContact& m, Breaches& breaches) {
  if (m.long_cutoff && m.short_cutoff && *m.short_cutoff >= *m.long_cutoff) {
    refuse("short_cutoff", "is not below contact.measured.long_cutoff", "nothing would be left of the surface",
           breaches);
  }
  if (m.step && m.short_cutoff && *m.step > *m.short_cutoff) {
    refuse("step", "is above contact.measured.short_cutoff", "no wavelength below the distance of points is seen",
           breaches);
  }
  if (m.regions && *m.regions != std::floor(*m.regions)) {
    refuse("regions", "is not a whole number", "for example 12", breaches);
  }
}

void check_correlation(const char* key, const std::optional<double>& correlation, const std::optional<double>& one,
                       const std::optional<double>& other, Breaches& breaches) {
  if (!correlation || (one && other)) return;
  refuse(key, "is stated without the standard deviations of both", "state them too", breaches);
}

void check_correlations(const MeasuredContact& m, Breaches& breaches) {
  const auto &N = m.asperity_density_deviation, &beta = m.asperity_radius_deviation, &sigma = m.roughness_deviation;
  check_correlation("density_radius_correlation", m.density_radius_correlation, N, beta, breaches);
  check_correlation("density_roughness_correlation", m.density_roughness_correlation, N, sigma, breaches);
  check_correlation("radius_roughness_correlation", m.radius_roughness_correlation, beta, sigma, breaches);
  const double a = m.density_radius_correlation.value_or(0), b = m.density_roughness_correlation.value_or(0),
               c = m.radius_roughness_correlation.value_or(0);
  // Written with few digits, correlations near 1 may miss by their last one.
  constexpr double kRounding = 1e-3;
  if (1 + 2 * a * b * c - a * a - b * b - c * c < -kRounding) {
    refuse("density_radius_correlation", "and the other two correlations cannot hold at once",
           "no set of regions has them; were they taken from one set?", breaches);
  }
}

void check_shear_strength(const MeasuredShearStrength& s, Breaches& breaches) {
  if (s.method && *s.method != "silicon" && *s.method != "geometry" && *s.method != "wedge") {
    refuse("shear_strength.method", "= \"" + *s.method + "\" is unknown", "one of: silicon, geometry, wedge", breaches);
  }
  if ((s.calibration_deviation || s.reference_deviation) && !s.calibration) {
    refuse("shear_strength.calibration", "is missing",
           "the calibration is common to all samples that were measured with it: give it a name", breaches);
  }
}

}  // namespace

void append_measured_breaches(const MeasuredContact& measured, std::vector<RuleBreach>& breaches) {
  check_lengths(measured, breaches);
  check_correlations(measured, breaches);
  check_shear_strength(measured.shear_strength, breaches);
}

}  // namespace ringfilm::cycle
