#include "ringfilm/study/design/measured_factors.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "ringfilm/base/number_text.hpp"

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

/// A pair of surfaces of a base: that of its ring, or of rings of a pack that state the same.
struct Pair {
  std::size_t base = 0;
  std::string owner;               ///< words for the owner of the scatter, in names of factors
  cycle::Contact contact;          ///< a copy, because factors are added to the study that holds it
  std::vector<std::string> rings;  ///< what its keys begin with: "ring.1.", or nothing
};

/// Do both state the same numbers with the same scatter?
bool is_alike(const cycle::Contact& a, const cycle::Contact& b) {
  const auto numbers = [](const cycle::Contact& c) {
    const cycle::MeasuredContact& m = c.measured;
    const cycle::MeasuredShearStrength& s = m.shear_strength;
    return std::tuple(c.model, c.asperity_density, c.asperity_radius, c.roughness, c.plateau, c.law_file, c.law_shift,
                      c.law_factor, c.boundary_shear_strength_coefficient, m.asperity_density_deviation,
                      m.asperity_radius_deviation, m.roughness_deviation, m.density_radius_correlation,
                      m.density_roughness_correlation, m.radius_roughness_correlation, s.slope_deviation,
                      s.calibration_deviation, s.reference_deviation, s.calibration);
  };
  return numbers(a) == numbers(b);
}

std::vector<Pair> pairs_of(const Study& study, std::size_t b) {
  const Base& base = study.bases.at(b);
  if (!base.input.is_pack()) return {{b, base.name, base.input.contact, {""}}};
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < base.input.rings.size(); ++i) {
    const cycle::Contact& contact = base.input.rings[i].contact;
    const std::string number = std::to_string(i + 1);
    const auto same =
        std::find_if(pairs.begin(), pairs.end(), [&](const Pair& p) { return is_alike(p.contact, contact); });
    if (same == pairs.end()) {
      pairs.push_back({b, base.name + " ring " + number, contact, {"ring." + number + "."}});
    } else {
      same->owner += "+" + number;
      same->rings.push_back("ring." + number + ".");
    }
  }
  if (pairs.size() == 1) pairs.front().owner = base.name;
  return pairs;
}

class MeasuredFactors {
 public:
  MeasuredFactors(Study& study, const MeasuredSharing& sharing) : study_(study), sharing_(sharing) {}

  void add(std::size_t b) {
    const std::size_t before = n_errors_;
    for (const Pair& pair : pairs_of(study_, b)) {
      add_contact(pair);
      add_shear_strength(pair);
    }
    if (n_errors_ > before) return;
    throw InputError("base \"" + study_.bases.at(b).name + "\" states no scatter in [contact.measured]",
                     "`ringfilm pair` and `ringfilm lateral-force` write it, `ringfilm contact` that of a law; or "
                     "state a distribution in [[factor]]");
  }

 private:
  static std::vector<Target> targets(const Pair& pair, const std::string& key) {
    std::vector<Target> all;
    for (const std::string& ring : pair.rings) all.push_back({pair.base, ring + key, 1.0});
    return all;
  }

  std::optional<std::size_t> add_normal(const Pair& pair, const std::string& key, double mean,
                                        const Deviation& deviation, const char* unit, const char* display_unit) {
    if (!varies(deviation)) return std::nullopt;
    ++n_errors_;
    const std::string name = key.substr(key.find('.') + 1) + " of " + pair.owner;
    study_.factors.push_back(
        {name, targets(pair, key), FactorMode::kSet, positive(mean, *deviation), unit, display_unit, {}, kSource});
    return study_.factors.size() - 1;
  }

  void correlate(const std::optional<std::size_t>& one, const std::optional<std::size_t>& other,
                 const std::optional<double>& value) {
    if (one && other && value && *value != 0) study_.correlations.push_back({*one, *other, *value, {}});
  }

  void add_contact(const Pair& pair) {
    const cycle::Contact& contact = pair.contact;
    const cycle::MeasuredContact& m = contact.measured;
    if (contact.model == cycle::ContactLaw::kTable) return add_law(pair);
    const auto N = add_normal(pair, "contact.asperity_density", contact.asperity_density, m.asperity_density_deviation,
                              "m-2", "um-2");
    const auto beta =
        add_normal(pair, "contact.asperity_radius", contact.asperity_radius, m.asperity_radius_deviation, "m", "um");
    const auto sigma = add_normal(pair, "contact.roughness", contact.roughness, m.roughness_deviation, "m", "um");
    correlate(N, beta, m.density_radius_correlation);
    correlate(N, sigma, m.density_roughness_correlation);
    correlate(beta, sigma, m.radius_roughness_correlation);
  }

  /// The two numbers of a measured contact law: its shift and its factor.
  void add_law(const Pair& pair) {
    const cycle::Contact& contact = pair.contact;
    const cycle::ContactLawTable& law = *contact.law;
    const auto shift = add_shift(pair, contact.law_shift, law.shift_deviation);
    const auto factor = add_normal(pair, "contact.law_factor", contact.law_factor, law.factor_deviation, "1", "1");
    if (factor) study_.factors[*factor].variation = lognormal(contact.law_factor, *law.factor_deviation);
    correlate(shift, factor, law.shift_factor_correlation);
  }

  /// Adds the shift of a contact law, which may have either sign.
  std::optional<std::size_t> add_shift(const Pair& pair, double mean, const Deviation& deviation) {
    const auto added = add_normal(pair, "contact.law_shift", mean, deviation, "m", "nm");
    if (added) study_.factors[*added].variation = normal(mean, *deviation);
    return added;
  }

  void add_shear_strength(const Pair& pair) {
    const cycle::MeasuredShearStrength& s = pair.contact.measured.shear_strength;
    const std::string calibration = s.calibration.value_or("");
    add_scale(pair, "slope of zeta", pair.owner, s.slope_deviation);
    add_scale(pair, "calibration", sharing_.calibration == Shared::kCommon ? calibration : pair.owner,
              s.calibration_deviation);
    add_scale(pair, "reference", sharing_.reference == Shared::kCommon ? calibration : pair.owner,
              s.reference_deviation);
  }

  /// Lets an error of that kind and owner act on a pair, too.
  void add_scale(const Pair& pair, const std::string& kind, const std::string& owner, const Deviation& deviation) {
    if (!varies(deviation)) return;
    ++n_errors_;
    const double relative = *deviation / pair.contact.boundary_shear_strength_coefficient;
    const auto [found, is_first] = scales_.try_emplace({kind, owner}, study_.factors.size());
    if (is_first) {
      const std::string name = kind + " of " + owner;
      study_.factors.push_back(
          {name, targets(pair, kZeta), FactorMode::kScale, positive(1, relative), "1", "1", {}, kSource});
      return;
    }
    Factor& common = study_.factors[found->second];
    const double known = std::get<Distribution>(common.variation).deviation;
    constexpr double kRounding = 0.02;
    if (!(std::abs(relative - known) <= kRounding * known)) {
      throw InputError("the " + kind + " of " + owner + " has the relative deviation " + number_text(known) +
                           " in one base and " + number_text(relative) + " in base \"" + pair.owner + "\"",
                       "one error cannot have two sizes: check the deviations, or give the calibrations two names");
    }
    const std::vector<Target> more = targets(pair, kZeta);
    common.targets.insert(common.targets.end(), more.begin(), more.end());
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
