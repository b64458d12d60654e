#include "ringfilm/study/design/measured_factors.hpp"

#include <cmath>
#include <map>
#include <optional>
#include <string>

#include "ringfilm/study/wording.hpp"

namespace ringfilm::study {
namespace {

using Deviation = std::optional<double>;

const std::string kSource = "measured: [contact.measured] of the base";
const std::string kZeta = "contact.boundary_shear_strength_coefficient";

Distribution positive(double mean, double deviation) {
  Distribution d = normal(mean, deviation);
  d.lowest = 0;
  return d;
}

bool varies(const Deviation& deviation) { return deviation && *deviation != 0; }

class MeasuredFactors {
 public:
  MeasuredFactors(Study& study, const MeasuredSharing& sharing) : study_(study), sharing_(sharing) {}

  void add(std::size_t b) {
    const Base& base = study_.bases.at(b);
    const std::size_t before = n_errors_;
    add_contact(b, base);
    add_shear_strength(b, base);
    if (n_errors_ > before) return;
    throw InputError("base \"" + base.name + "\" states no scatter in [contact.measured]",
                     "`ringfilm pair` and `ringfilm lateral-force` write it, `ringfilm contact` that of a law; or "
                     "state a distribution in [[factor]]");
  }

 private:
  std::optional<std::size_t> add_normal(std::size_t b, const std::string& key, double mean, const Deviation& deviation,
                                        const char* unit, const char* display_unit) {
    if (!varies(deviation)) return std::nullopt;
    ++n_errors_;
    const std::string name = key.substr(key.find('.') + 1) + " of " + study_.bases[b].name;
    study_.factors.push_back(
        {name, {{b, key, 1.0}}, FactorMode::kSet, positive(mean, *deviation), unit, display_unit, {}, kSource});
    return study_.factors.size() - 1;
  }

  void correlate(const std::optional<std::size_t>& one, const std::optional<std::size_t>& other,
                 const std::optional<double>& value) {
    if (one && other && value && *value != 0) study_.correlations.push_back({*one, *other, *value, {}});
  }

  void add_contact(std::size_t b, const Base& base) {
    // A copy, because factors are added to the study that holds it.
    const cycle::Contact contact = base.input.contact;
    const cycle::MeasuredContact& m = contact.measured;
    if (contact.model == cycle::ContactLaw::kTable) return add_law(b, contact);
    const auto N = add_normal(b, "contact.asperity_density", contact.asperity_density, m.asperity_density_deviation,
                              "m-2", "um-2");
    const auto beta =
        add_normal(b, "contact.asperity_radius", contact.asperity_radius, m.asperity_radius_deviation, "m", "um");
    const auto sigma = add_normal(b, "contact.roughness", contact.roughness, m.roughness_deviation, "m", "um");
    correlate(N, beta, m.density_radius_correlation);
    correlate(N, sigma, m.density_roughness_correlation);
    correlate(beta, sigma, m.radius_roughness_correlation);
  }

  /// The two numbers of a measured contact law: its shift and its factor.
  void add_law(std::size_t b, const cycle::Contact& contact) {
    const cycle::ContactLawTable& law = *contact.law;
    const auto shift = add_shift(b, contact.law_shift, law.shift_deviation);
    const auto factor = add_normal(b, "contact.law_factor", contact.law_factor, law.factor_deviation, "1", "1");
    if (factor) study_.factors[*factor].variation = lognormal(contact.law_factor, *law.factor_deviation);
    correlate(shift, factor, law.shift_factor_correlation);
  }

  /// Of either sign.
  std::optional<std::size_t> add_shift(std::size_t b, double mean, const Deviation& deviation) {
    const auto added = add_normal(b, "contact.law_shift", mean, deviation, "m", "nm");
    if (added) study_.factors[*added].variation = normal(mean, *deviation);
    return added;
  }

  void add_shear_strength(std::size_t b, const Base& base) {
    const cycle::MeasuredShearStrength& s = base.input.contact.measured.shear_strength;
    const std::string calibration = s.calibration.value_or("");
    add_scale(b, "slope of zeta", base.name, s.slope_deviation);
    add_scale(b, "calibration", sharing_.calibration == Shared::kCommon ? calibration : base.name,
              s.calibration_deviation);
    add_scale(b, "reference", sharing_.reference == Shared::kCommon ? calibration : base.name, s.reference_deviation);
  }

  /// Lets an error of that kind and owner act on a base, too.
  void add_scale(std::size_t b, const std::string& kind, const std::string& owner, const Deviation& deviation) {
    if (!varies(deviation)) return;
    ++n_errors_;
    const double relative = *deviation / study_.bases[b].input.contact.boundary_shear_strength_coefficient;
    const auto [found, is_first] = scales_.try_emplace({kind, owner}, study_.factors.size());
    if (is_first) {
      const std::string name = kind + " of " + owner;
      study_.factors.push_back(
          {name, {{b, kZeta, 1.0}}, FactorMode::kScale, positive(1, relative), "1", "1", {}, kSource});
      return;
    }
    Factor& common = study_.factors[found->second];
    const double known = std::get<Distribution>(common.variation).deviation;
    constexpr double kRounding = 0.02;
    if (!(std::abs(relative - known) <= kRounding * known)) {
      throw InputError("the " + kind + " of " + owner + " has the relative deviation " + shown(known) +
                           " in one base and " + shown(relative) + " in base \"" + study_.bases[b].name + "\"",
                       "one error cannot have two sizes: check the deviations, or give the calibrations two names");
    }
    common.targets.push_back({b, kZeta, 1.0});
  }

  Study& study_;
  MeasuredSharing sharing_;
  std::map<std::pair<std::string, std::string>, std::size_t> scales_;
  std::size_t n_errors_ = 0;
};

}  // namespace

void add_measured_factors(Study& study, const std::vector<std::size_t>& bases, const MeasuredSharing& sharing) {
  MeasuredFactors factors(study, sharing);
  for (const std::size_t b : bases) factors.add(b);
}

}  // namespace ringfilm::study
