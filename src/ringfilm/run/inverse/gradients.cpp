#include "ringfilm/run/inverse/gradients.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "ringfilm/base/error.hpp"
#include "ringfilm/case/accuracy.hpp"
#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/io/case/case_edit.hpp"
#include "ringfilm/io/case/case_file.hpp"
#include "ringfilm/run/inverse/case_numbers.hpp"
#include "ringfilm/study/ensemble/threads.hpp"

namespace ringfilm::run {
namespace {

using cycle::Case;
using cycle::Field;

/// Half the narrower width over the value of the input, and a temperature's [K]. Where the oil on the liner is followed
/// its settling scatters the values, and the width is larger.
constexpr double kWidth = 2e-3, kWidthWithOil = 1e-2, kKelvin = 0.25, kKelvinWithOil = 2;
/// Tolerances with which the scatter of the iteration stays below what the differences resolve.
constexpr double kTolerance = 1e-12, kStepErrorWithOil = 1e-5;
/// Places of a difference in halves of the narrower width.
constexpr std::array<double, 4> kPlaces = {-2, -1, 1, 2};

bool follows_oil(const Case& c) {
  const Case& one = c.rings.empty() ? c : c.rings.front();
  return one.film.supply_at_inlet() == cycle::OilSupply::kFilmOnLiner;
}

void smooth(Case& c, bool with_oil) {
  c = cycle::with_accuracy(c);
  c.solver.accuracy.reset();
  c.solver.crank_step_control = cycle::StepControl::kFixed;
  c.solver.tolerance = std::min(c.solver.tolerance, kTolerance);
  if (with_oil) c.solver.step_error = std::min(c.solver.step_error, kStepErrorWithOil);
}

/// On one grid in cells and steps, and finding more digits of the film than a result needs.
Case smoothed(Case c) {
  const bool with_oil = follows_oil(c);
  smooth(c, with_oil);
  for (Case& ring : c.rings) smooth(ring, with_oil);
  ask_for_curves(c, {});
  return c;
}

bool is_number(const Field& field) {
  return std::holds_alternative<cycle::NumberKind>(field.kind) ||
         std::holds_alternative<cycle::OptionalNumberKind>(field.kind);
}

/// Value of a number of the case; nothing where it has none.
std::optional<double> number_of(const Case& c, const std::string& key) {
  const auto [field, of] = io::located_key(c, key);
  if (const auto* number = std::get_if<cycle::NumberKind>(&field.kind)) return number->ref(of);
  if (const auto* number = std::get_if<cycle::OptionalNumberKind>(&field.kind)) return number->ref(of);
  return std::nullopt;
}

double half_width(const Field& field, double value, bool with_oil) {
  if (field.unit == "K") return with_oil ? kKelvinWithOil : kKelvin;
  return (with_oil ? kWidthWithOil : kWidth) * std::abs(value);
}

/// The case with another number, checked as its user states it, and then smoothed.
Case with_number(Case c, const std::string& key, const Field& field, double value, const io::Units& units) {
  const std::string text =
      field.unit == "1" ? io::exact_text(value) : "\"" + io::exact_text(value) + " " + field.unit + "\"";
  io::update(c, {{key, io::parse_toml_value(text)}}, units);
  io::check_case(c);
  return smoothed(std::move(c));
}

/// What is computed for one input.
struct Difference {
  double half_width = 0;
  std::array<std::map<std::string, double>, 4> values;
};

void conclude(const Difference& difference, const std::vector<cycle::Quantity>& quantities, bool with_oil,
              Gradient& gradient) {
  for (const cycle::Quantity& quantity : quantities) {
    if (quantity.unit == "degree") continue;
    std::array<double, 4> at{};
    for (std::size_t i = 0; i < at.size(); ++i) {
      const auto found = difference.values[i].find(quantity.name);
      at[i] = found == difference.values[i].end() ? std::numeric_limits<double>::quiet_NaN() : found->second;
    }
    const double narrow = (at[2] - at[1]) / (2 * difference.half_width),
                 wide = (at[3] - at[0]) / (4 * difference.half_width);
    if (!std::isfinite(narrow) || !std::isfinite(wide)) continue;
    // Extrapolation would magnify the scatter of the oil that settles.
    const double step = with_oil ? wide - narrow : (narrow - wide) / 3;
    gradient.derivatives[quantity.name] = {narrow + step, std::abs(step), (at[1] + at[2]) / 2};
  }
}

}  // namespace

std::vector<std::string> differentiable_keys(const Case& c) {
  std::vector<std::string> keys;
  for (const io::CaseEntry& entry : io::case_entries(c)) {
    if (entry.assumed) continue;
    const Field& field = io::located_key(c, entry.key).field;
    const bool is_of_solver =
        field.key.starts_with("solver.") || field.key.starts_with("output.") || field.key.ends_with("_step");
    const bool is_whole = field.key == "engine.cylinders";
    if (is_number(field) && !field.is_for_record && !is_of_solver && !is_whole && entry.value_si != 0) {
      keys.push_back(entry.key);
    }
  }
  return keys;
}

std::vector<Gradient> gradients(const Case& c, std::vector<std::string> keys, int threads) {
  if (keys.empty()) keys = differentiable_keys(c);
  const Case base = smoothed(c);
  const bool with_oil = follows_oil(base);
  const io::Units units;
  const std::vector<cycle::Quantity> quantities = value_quantities(base);
  std::vector<Gradient> all;
  std::vector<Difference> differences;
  std::vector<Case> cases;
  for (const std::string& key : keys) {
    const Field& field = io::located_key(base, key).field;
    const std::optional<double> value = number_of(base, key);
    if (!is_number(field) || !value || *value == 0) {
      throw InputError("no gradient with respect to " + key + ": it is not a number of the case that differs from 0",
                       "name numbers that the case states, such as ring.face_width");
    }
    all.push_back({key, *value, {}, ""});
    differences.push_back({half_width(field, *value, with_oil), {}});
    for (const double place : kPlaces) {
      Case changed = base;
      try {
        changed = with_number(c, key, field, *value + place * differences.back().half_width, units);
      } catch (const InputError& error) {
        all.back().reason = error.faults().front().message;
      }
      cases.push_back(std::move(changed));
    }
  }
  std::atomic<std::size_t> next = 0;
  std::vector<std::string> failed(cases.size());
  const int n = std::min(study::n_threads(threads), static_cast<int>(cases.size()));
  study::on_threads(std::max(n, 1), [&](int) {
    for (std::size_t i = next++; i < cases.size(); i = next++) {
      if (!all[i / kPlaces.size()].reason.empty()) continue;
      try {
        differences[i / kPlaces.size()].values[i % kPlaces.size()] = case_numbers(cases[i], {}).values;
      } catch (const ConvergenceError& error) {
        failed[i] = error.what();
      } catch (const InputError& error) {
        failed[i] = error.faults().front().message;
      }
    }
  });
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (!failed[i].empty()) all[i / kPlaces.size()].reason = failed[i];
  }
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (all[k].reason.empty()) conclude(differences[k], quantities, with_oil, all[k]);
  }
  return all;
}

}  // namespace ringfilm::run
