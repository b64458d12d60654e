#include "ringfilm/cycle/menisci/menisci_step.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "ringfilm/cycle/integration/cycle_film.hpp"

namespace ringfilm::cycle {
namespace {

/// Cells across the face for the pressure, and for the asperities: with many more h_m is the same within 3e-4
/// in the mean.
constexpr int kCells = 20, kContactCells = 48;
/// Pressure up to which an oil is served, over the mean pressure on the face [-].
constexpr double kServedOverMean = 4;

/// A rate differs from the slope of the curve through three ends of steps by less, over the step: of ln h_m, and of a
/// meniscus [m].
constexpr double kMaxOffOfFilm = 0.01, kMaxOffOfPlace = 3e-6;

/// A cubic by its ends and its slopes there, each times the length of the step.
double cubic(double share, double from, double to, double first, double last) {
  const double rise = to - from, bend = first + last - 2 * rise;
  return from + share * (first + share * (rise - first - bend + share * bend));
}

film::FilmGrid grid_of_cells(const Setup& setup, int cells) {
  Setup on_cells = setup;
  on_cells.input.solver.cells = cells;
  on_cells.input.solver.cell_lengths = CellLengths::kByGap;
  return face_grid(on_cells);
}

double between(double share, double from, double to) { return from + share * (to - from); }

}  // namespace

film::FilmGrid menisci_grid(const Setup& setup) { return grid_of_cells(setup, kCells); }

film::FilmProblem menisci_contact(const Setup& setup) {
  film::FilmProblem problem;
  problem.grid = grid_of_cells(setup, kContactCells);
  problem.contact = setup.ring.contact.get();
  problem.contact_spread = setup.input.contact.lambda_ratio == LambdaRatio::kLocal ? film::ContactSpread::kLocal
                                                                                   : film::ContactSpread::kNominal;
  return problem;
}

MenisciConditions menisci_conditions(const Setup& setup, double width, double crank_angle_deg, double direction,
                                     double highest_pressure, const HeatBefore& heat) {
  RingConditions at = ring_conditions(setup, crank_angle_deg, film::kSteady, heat);
  const double served = std::max(highest_pressure, kServedOverMean * at.inputs.load / width);
  const film::Surplus surplus =
      setup.input.supply.scraped == Scraped::kDiscarded ? film::Surplus::kIsLost : film::Surplus::kStays;
  film::MenisciInputs inputs(at.inputs, direction, surplus, served);
  return {std::move(at), std::move(inputs)};
}

film::MenisciState MenisciStep::state_at(double crank_angle_deg) const {
  const double length = to_deg - from_deg, share = (crank_angle_deg - from_deg) / length;
  const auto unknown = [&](double begin, double end, int k) {
    return cubic(share, begin, end, rate_from[k] * length, rate_to[k] * length);
  };
  film::MenisciState state = from;
  state.ln_h_m = unknown(from.ln_h_m, to.ln_h_m, 0);
  if (from.left.place == film::MeniscusPlace::kFree) state.left.x = unknown(from.left.x, to.left.x, 1);
  if (from.right.place == film::MeniscusPlace::kFree) state.right.x = unknown(from.right.x, to.right.x, 2);
  state.bead = between(share, from.bead, to.bead);
  return state;
}

void limit_rates(std::vector<MenisciStep>& steps) {
  const auto values = [](const film::MenisciState& state) {
    return std::array<double, 3>{state.ln_h_m, state.left.x, state.right.x};
  };
  const auto secant = [&](const MenisciStep& step, int k) {
    return (values(step.to)[k] - values(step.from)[k]) / (step.to_deg - step.from_deg);
  };
  const auto limit = [](double slope, double length, int k, double& rate) {
    if (std::abs(rate - slope) * length > (k == 0 ? kMaxOffOfFilm : kMaxOffOfPlace)) rate = slope;
  };
  for (std::size_t i = 0; i <= steps.size(); ++i) {
    MenisciStep* before = i > 0 ? &steps[i - 1] : nullptr;
    MenisciStep* after = i < steps.size() ? &steps[i] : nullptr;
    const bool continues =
        before != nullptr && after != nullptr && before->has_places_of(*after) && before->direction == after->direction;
    for (int k = 0; k < 3; ++k) {
      const double length_before = before != nullptr ? before->to_deg - before->from_deg : 0;
      const double length_after = after != nullptr ? after->to_deg - after->from_deg : 0;
      double slope_before = before != nullptr ? secant(*before, k) : 0;
      double slope_after = after != nullptr ? secant(*after, k) : 0;
      if (continues) {
        slope_before = slope_after =
            (slope_before * length_after + slope_after * length_before) / (length_before + length_after);
      }
      if (before != nullptr) limit(slope_before, length_before, k, before->rate_to[k]);
      if (after != nullptr) limit(slope_after, length_after, k, after->rate_from[k]);
    }
  }
}

OilBeyond MenisciStep::beyond_at(double crank_angle_deg) const {
  const double share = (crank_angle_deg - from_deg) / (to_deg - from_deg);
  const OilBeyond &a = beyond_from, &b = beyond_to;
  return {{between(share, a.next.left, b.next.left), between(share, a.next.right, b.next.right)},
          between(share, a.left_edge, b.left_edge),
          between(share, a.middle, b.middle),
          between(share, a.right_edge, b.right_edge)};
}

}  // namespace ringfilm::cycle
