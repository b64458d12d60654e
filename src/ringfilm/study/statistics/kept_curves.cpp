#include "ringfilm/study/statistics/kept_curves.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

#include "ringfilm/cycle/integration/kinematics.hpp"
#include "ringfilm/study/wording.hpp"

namespace ringfilm::study {
namespace {

/// Steps that differ by less are the same [degree].
constexpr double kSameStep = 1e-9;

const cycle::CurveQuantity* find_curve(const std::string& name) {
  const auto& all = cycle::curve_quantities();
  // The first is the axis itself.
  const auto found = std::find_if(all.begin() + 1, all.end(), [&name](const auto& one) { return one.name == name; });
  return found == all.end() ? nullptr : &*found;
}

std::size_t n_angles(const OutputSelection& keep) {
  return static_cast<std::size_t>(std::lround(cycle::kCycleDeg / keep.crank_step_deg));
}

/// Place among the samples, which begin at firing TDC, of the first angle of the axis.
std::size_t first_sample(std::size_t n) { return (n + 1) / 2; }

bool divides(double step_deg, double whole_deg) {
  return std::abs(std::remainder(whole_deg, step_deg)) < kSameStep * whole_deg / step_deg;
}

}  // namespace

std::vector<const cycle::CurveQuantity*> kept_quantities(const OutputSelection& keep) {
  std::vector<const cycle::CurveQuantity*> kept;
  if (keep.curves == Curves::kNone) return kept;
  for (const std::string& name : keep.quantities) {
    kept.push_back(find_curve(name));
    if (kept.back() == nullptr) throw std::logic_error("a curve that does not exist: " + name);
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
}

std::vector<float> kept_numbers(const OutputSelection& keep, const std::vector<cycle::Sample>& samples) {
  std::vector<float> numbers;
  const auto kept = kept_quantities(keep);
  if (kept.empty()) return numbers;
  const std::size_t n = n_angles(keep);
  if (samples.size() != n) throw std::logic_error("a case that was not asked for the angles that are kept");
  numbers.reserve(kept.size() * n);
  for (const cycle::CurveQuantity* quantity : kept) {
    for (std::size_t k = 0; k < n; ++k)
      numbers.push_back(static_cast<float>(samples[(k + first_sample(n)) % n].*quantity->value));
  }
  return numbers;
}

std::vector<float> no_kept_numbers(const OutputSelection& keep) {
  if (keep.curves == Curves::kNone) return {};
  return std::vector<float>(keep.quantities.size() * n_angles(keep), std::numeric_limits<float>::quiet_NaN());
}

std::vector<Fault> faults_of_keep(const Study& study) {
  std::vector<Fault> faults;
  const OutputSelection& keep = study.keep;
  if (keep.curves == Curves::kNone) return faults;
  const std::string step = "keep.crank_step = " + shown(keep.crank_step_deg) + " degree ";
  if (keep.quantities.empty()) {
    faults.push_back({keep.quantities_mark, "keep.quantities names no curve", "name some, or keep curves = \"none\""});
  }
  std::set<std::string> seen;
  for (const std::string& name : keep.quantities) {
    if (find_curve(name) == nullptr) {
      faults.push_back({keep.quantities_mark, "keep.quantities: there is no curve " + name,
                        "for example min_film_thickness, total_friction"});
    } else if (!seen.insert(name).second) {
      faults.push_back({keep.quantities_mark, "keep.quantities names " + name + " twice", "keep one of them"});
    }
  }
  const double numbers = cycle::kCycleDeg / keep.crank_step_deg * static_cast<double>(keep.quantities.size());
  if (!(keep.crank_step_deg > 0) || keep.crank_step_deg > cycle::kCycleDeg / 2 ||
      !divides(keep.crank_step_deg, cycle::kCycleDeg)) {
    faults.push_back({keep.crank_step_mark, step + "does not divide the cycle of 720 degrees",
                      "whole steps must make a cycle, for example \"2 degree\""});
  } else if (numbers > static_cast<double>(kMostCurveNumbers)) {
    faults.push_back(
        {keep.crank_step_mark,
         "the curves of a scenario are " + shown(numbers) + " numbers, more than " + std::to_string(kMostCurveNumbers),
         "keep fewer quantities, or a larger keep.crank_step"});
  } else {
    for (const Base& base : study.bases) {
      const double integration = base.input.solver.crank_step_deg;
      if (divides(integration, keep.crank_step_deg)) continue;
      faults.push_back({keep.crank_step_mark,
                        step + "is not a multiple of solver.crank_step = " + shown(integration) + " degree of base \"" +
                            base.name + "\"",
                        "take a multiple that divides 720"});
    }
  }
  return faults;
}

}  // namespace ringfilm::study
