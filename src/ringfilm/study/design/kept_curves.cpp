#include "ringfilm/study/design/kept_curves.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

#include "ringfilm/base/find_by_name.hpp"
#include "ringfilm/base/number_text.hpp"
#include "ringfilm/cycle/setup/kinematics.hpp"
#include "ringfilm/study/design/scenario.hpp"
#include "ringfilm/study/design/study_values.hpp"

namespace ringfilm::study {
namespace {

/// Steps that differ by less are the same [degree].
constexpr double kSameStep = 1e-9;

const cycle::CurveQuantity* find_curve(const std::string& name) {
  const cycle::CurveQuantity* found = find_by_name(cycle::curve_quantities(), name);
  return found == &cycle::curve_quantities().front() ? nullptr : found;  // the first is the axis itself
}

std::size_t n_angles(const OutputSelection& keep) {
  return static_cast<std::size_t>(std::lround(cycle::kCycleDeg / keep.crank_step_deg));
}

/// Place among the samples, which begin at firing TDC, of the first angle of the axis.
std::size_t first_sample(std::size_t n) { return (n + 1) / 2; }

/// Curves of the rings of a pack, with what the rails of an oil ring have together.
const std::vector<RingValue>& ring_curves() {
  using enum RingValue::Rails;
  static const std::vector<RingValue> curves = {
      {"total_friction", kSum},     {"friction_on_liner", kSum}, {"boundary_friction", kSum},
      {"viscous_friction", kSum},   {"power_loss", kSum},        {"applied_load", kSum},
      {"hydrodynamic_load", kSum},  {"asperity_load", kSum},     {"archard_wear_load_rate", kSum},
      {"min_film_thickness", kMin}, {"lambda_ratio", kMin},      {"peak_film_pressure", kMax}};
  return curves;
}

/// Do these add up to what the piston feels?
bool adds_up(const std::string& name) {
  static const std::set<std::string> names = {"total_friction", "friction_on_liner", "boundary_friction",
                                              "viscous_friction", "power_loss"};
  return names.contains(name);
}

bool is_of_packs(const Study& study) { return !study.bases.empty() && study.bases.front().input.is_pack(); }

KeptCurve of_pack(const cycle::CurveQuantity& source, std::size_t ring) {
  KeptCurve curve{source, &source, ring};
  if (ring > 0) curve.quantity.name = ring_value_name(ring, source.name);
  curve.quantity.long_name.insert(0, ring > 0 ? "ring " + std::to_string(ring) + ": " : "all rings: ");
  curve.quantity.symbol.clear();
  return curve;
}

std::string list_of_ring_curves() {
  std::string list;
  for (const RingValue& one : ring_curves()) list += (list.empty() ? "" : ", ") + std::string(one.name);
  return list;
}

bool divides(double step_deg, double whole_deg) {
  return std::abs(std::remainder(whole_deg, step_deg)) < kSameStep * whole_deg / step_deg;
}

}  // namespace

std::vector<KeptCurve> kept_curves(const Study& study) {
  std::vector<KeptCurve> kept;
  if (study.keep.curves == Curves::kNone) return kept;
  for (const std::string& name : study.keep.quantities) {
    const cycle::CurveQuantity* source = find_curve(name);
    if (source == nullptr) throw std::logic_error("a curve that does not exist: " + name);
    if (!is_of_packs(study)) {
      kept.push_back({*source, source, 0});
      continue;
    }
    if (adds_up(name)) kept.push_back(of_pack(*source, 0));
    const std::size_t n_rings = study.bases.front().input.rings.size();
    for (std::size_t ring = 1; ring <= n_rings; ++ring) kept.push_back(of_pack(*source, ring));
  }
  return kept;
}

std::vector<double> kept_angles(const OutputSelection& keep) {
  std::vector<double> angles;
  if (keep.curves == Curves::kNone) return angles;
  const std::size_t n = n_angles(keep);
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t at = k + first_sample(n);
    const double turn = at < n ? cycle::kCycleDeg : 0;
    angles.push_back(cycle::kCycleDeg * static_cast<double>(at % n) / static_cast<double>(n) - turn);
  }
  return angles;
}

void ask_for_kept(const OutputSelection& keep, cycle::Case& c) {
  c.output = {};
  if (keep.curves == Curves::kNone) {
    c.output.crank_angles_deg = {0};
  } else {
    c.output.crank_angle_step_deg = keep.crank_step_deg;
  }
  for (cycle::Case& ring : c.rings) ask_for_kept(keep, ring);
}

namespace {

/// One curve over the axis [SI].
std::vector<double> over_axis(const OutputSelection& keep, const cycle::CurveQuantity& quantity,
                              const std::vector<cycle::Sample>& samples) {
  const std::size_t n = n_angles(keep);
  if (samples.size() != n) throw std::logic_error("a case that was not asked for the angles that are kept");
  std::vector<double> curve;
  curve.reserve(n);
  for (std::size_t k = 0; k < n; ++k) curve.push_back(samples[(k + first_sample(n)) % n].*quantity.value);
  return curve;
}

}  // namespace

std::vector<float> kept_numbers(const OutputSelection& keep, const std::vector<cycle::Sample>& samples) {
  std::vector<float> numbers;
  if (keep.curves == Curves::kNone) return numbers;
  for (const std::string& name : keep.quantities) {
    const std::vector<double> curve = over_axis(keep, *find_curve(name), samples);
    numbers.insert(numbers.end(), curve.begin(), curve.end());
  }
  return numbers;
}

std::vector<float> kept_numbers_of_pack(const Study& study, const std::vector<cycle::CycleResult>& faces,
                                        const std::vector<std::size_t>& numbers) {
  std::vector<float> all;
  for (const KeptCurve& kept : kept_curves(study)) {
    const RingValue* ring_curve = find_by_name(ring_curves(), kept.source->name);
    if (ring_curve == nullptr) throw std::logic_error("a curve that rings of a pack do not have: " + kept.source->name);
    std::vector<double> curve;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      if (kept.ring != 0 && numbers[i] != kept.ring) continue;
      const std::vector<double> of_face = over_axis(study.keep, *kept.source, faces[i].samples);
      if (curve.empty()) {
        curve = of_face;
        continue;
      }
      for (std::size_t k = 0; k < curve.size(); ++k) curve[k] = together(ring_curve->rails, curve[k], of_face[k]);
    }
    all.insert(all.end(), curve.begin(), curve.end());
  }
  return all;
}

std::vector<float> no_kept_numbers(const Study& study) {
  if (study.keep.curves == Curves::kNone) return {};
  return std::vector<float>(kept_curves(study).size() * n_angles(study.keep), std::numeric_limits<float>::quiet_NaN());
}

std::vector<Fault> faults_of_keep(const Study& study) {
  std::vector<Fault> faults;
  const OutputSelection& keep = study.keep;
  if (keep.curves == Curves::kNone) return faults;
  const std::string step = "keep.crank_step = " + number_text(keep.crank_step_deg) + " degree ";
  if (study.compute == Compute::kGas) {
    faults.push_back({keep.quantities_mark, "curves are those of films, and the study computes the gas alone",
                      "leave curves out; `ringfilm gas --csv` has the curves of the gas of one case"});
  }
  if (keep.quantities.empty()) {
    faults.push_back({keep.quantities_mark, "keep.quantities names no curve", "name some, or keep curves = \"none\""});
  }
  std::set<std::string> seen;
  for (const std::string& name : keep.quantities) {
    if (find_curve(name) == nullptr) {
      faults.push_back({keep.quantities_mark, "keep.quantities: there is no curve " + name,
                        "for example min_film_thickness, total_friction"});
    } else if (is_of_packs(study) && find_by_name(ring_curves(), name) == nullptr) {
      faults.push_back({keep.quantities_mark, "keep.quantities: " + name + " is not kept of the rings of a pack",
                        "name some of " + list_of_ring_curves()});
    } else if (!seen.insert(name).second) {
      faults.push_back({keep.quantities_mark, "keep.quantities names " + name + " twice", "keep one of them"});
    }
  }
  const std::size_t n_rings = is_of_packs(study) ? study.bases.front().input.rings.size() : 0;
  const double numbers =
      cycle::kCycleDeg / keep.crank_step_deg * static_cast<double>(keep.quantities.size() * (n_rings + 1));
  if (!(keep.crank_step_deg > 0) || keep.crank_step_deg > cycle::kCycleDeg / 2 ||
      !divides(keep.crank_step_deg, cycle::kCycleDeg)) {
    faults.push_back({keep.crank_step_mark, step + "does not divide the cycle of 720 degrees",
                      "whole steps must make a cycle, for example \"2 degree\""});
  } else if (numbers > static_cast<double>(kMaxCurveNumbers)) {
    faults.push_back({keep.crank_step_mark,
                      "the curves of a scenario are " + number_text(numbers) + " numbers, more than " +
                          std::to_string(kMaxCurveNumbers),
                      "keep fewer quantities, or a larger keep.crank_step"});
  } else {
    for (const Base& base : study.bases) {
      const cycle::Case input = with_accuracy_of_study(base.input, study);
      const cycle::Solver& solver = input.is_pack() ? input.rings.front().solver : input.solver;
      const double integration = solver.crank_step_deg;
      // An accuracy chooses steps that end at the angles that are kept.
      if (solver.accuracy || divides(integration, keep.crank_step_deg)) continue;
      faults.push_back({keep.crank_step_mark,
                        step + "is not a multiple of solver.crank_step = " + number_text(integration) +
                            " degree of base \"" + base.name + "\"",
                        "take a multiple that divides 720"});
    }
  }
  return faults;
}

}  // namespace ringfilm::study
