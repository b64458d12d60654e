#include "ringfilm/film/menisci/menisci_film.hpp"

#include <algorithm>
#include <cmath>

#include "ringfilm/base/display.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/base/number_text.hpp"
#include "ringfilm/film/gas_reach.hpp"

namespace ringfilm::film {
namespace {

/// Length of the squeeze film that is added at the throat: with a tenth of it or three times as much FMEP is the same
/// within 0.2 % [m].
constexpr double kSqueezedLength = 30e-6;
/// Share of the load that the iteration leaves [-].
constexpr double kTolerance = 2e-5;
constexpr int kMaxIterations = 100;
/// After so many iterations densities follow by a share: in thin films of high pressure they decide the pressure.
constexpr int kPlainIterations = 8;
constexpr double kRelaxation = 0.4;
/// Hold of a film that no gas pushes back [m Pa^1/2].
constexpr double kUnlimitedHold = 1e150;

double cube(double x) { return x * x * x; }

/// A cubic by its ends and its slopes there, each times the length between them.
double cubic(double share, double from, double to, double first, double last) {
  const double rise = to - from, bend = first + last - 2 * rise;
  return from + share * (first + share * (rise - first - bend + share * bend));
}

}  // namespace

MenisciFilm::MenisciFilm(const FilmGrid& grid, const FilmProblem& contact)
    : grid_(&grid), contact_(&contact), throat_(lowest_place(grid)), asperities_(contact) {
  for (std::vector<double>* list : {&inverse_square_, &inverse_cube_, &reduced_, &pressure_, &slope_, &density_, &rho_,
                                    &cubes_, &squares_, &mass_, &squeezed_}) {
    list->resize(GapPoints::most(grid));
  }
}

PassingFilm MenisciFilm::passing_throat(const MenisciInputs& inputs, const MenisciInputs::Edge& gas, double h_m) const {
  return passing_film(inputs, gas, throat_length(*grid_, h_m, throat_.height), h_m + throat_.height);
}

double MenisciFilm::squeeze_resistance(const MenisciInputs& inputs, double h_m) const {
  const double eta = inputs.oil.at(inputs.left.reduced).slope * inputs.left.density;
  return eta * cube(kSqueezedLength / (h_m + throat_.height));
}

void MenisciFilm::lay_points(const MenisciInputs& inputs, const MenisciState& state) {
  const bool left_leads = inputs.left_leads();
  points_.set(*grid_, std::exp(state.ln_h_m), left_leads ? state.left.x : state.right.x, throat_.x,
              left_leads ? state.right.x : state.left.x);
  const std::vector<double>& h = points_.h();
  const std::size_t n = points_.size();
  for (std::size_t j = 0; j < n; ++j) {
    const double inverse = 1 / h[j];
    inverse_square_[j] = inverse * inverse;
    inverse_cube_[j] = inverse_square_[j] * inverse;
  }
  points_.integrate([&](std::size_t j) { return inverse_cube_[j]; }, cubes_);
  // Densities of a film nearby are better than none.
  if (n_rho_ != n) std::fill(rho_.begin(), rho_.end(), inputs.leading().density);
  n_rho_ = n;
}

/// Integrals with the densities at hand.
void MenisciFilm::integrate_flow() {
  points_.integrate([&](std::size_t j) { return rho_[j] * inverse_square_[j]; }, squares_);
  points_.integrate([&](std::size_t j) { return rho_[j]; }, mass_);
  points_.integrate([&](std::size_t j) { return mass_[j] * inverse_cube_[j]; }, squeezed_);
}

/// The place from the throat on at which a value is smallest: a pressure that reaches there that of the gas has no
/// slope, or falls no further behind the throat or up to the meniscus. @param value at a point  @param rise its slope
/// in the direction of the liner [1/m]  @param sense of the sign of the slope
template <class Value, class Rise, class Sense>
MenisciFilm::Outlet MenisciFilm::outlet(const Value& value, const Rise& rise, const Sense& sense) const {
  // No flow follows from the pressures at both ends of nothing.
  const std::size_t throat = std::max<std::size_t>(points_.at_place(), 1), n = points_.size();
  Outlet least = end_at(n - 1, value(n - 1));
  if (throat + 1 >= n) return least;
  double before = sense(throat);
  if (before >= 0 && throat == points_.at_place()) {
    if (const double at_throat = value(throat); at_throat <= least.value) least = end_at(throat, at_throat);
  }
  for (std::size_t j = throat + 1; j < n; ++j) {
    const double after = sense(j);
    if (before < 0 && after >= 0) {
      const double first = rise(j - 1), last = rise(j), t = first / (first - last);
      const double length = std::abs(points_.x()[j] - points_.x()[j - 1]);
      const auto between = [t](double from, double to) { return from + t * (to - from); };
      const double lowest = cubic(t, value(j - 1), value(j), first * length, last * length);
      if (lowest < least.value) {
        least = {j,
                 lowest,
                 between(cubes_[j - 1], cubes_[j]),
                 between(squeezed_[j - 1], squeezed_[j]),
                 between(mass_[j - 1], mass_[j]),
                 between(points_.x()[j - 1], points_.x()[j]),
                 false};
      }
    }
    before = after;
  }
  return least;
}

MenisciFilm::Outlet MenisciFilm::end_at(std::size_t point, double value) const {
  return {
      point + 1, value, cubes_[point], squeezed_[point], mass_[point], points_.x()[point], point == points_.at_place()};
}

MenisciState MenisciFilm::film_at_throat(const MenisciInputs& inputs, const MenisciState& dry) const {
  constexpr double kLength = 2 * kMinFilmLength;
  const double x = throat_.x;
  const bool left_presses = inputs.left.pressure > inputs.right.pressure ||
                            (inputs.left.pressure == inputs.right.pressure && inputs.left_leads());
  MenisciState film = dry;
  if ((left_presses && x + kLength < grid_->width) || x < kLength) {
    film.right = {x + kLength, MeniscusPlace::kFree};
  } else {
    film.left = {x - kLength, MeniscusPlace::kFree};
  }
  return film;
}

double MenisciFilm::growth(const MenisciInputs& inputs, const MenisciState& dry, const OnLiner& on_liner) {
  MenisciState film = film_at_throat(inputs, dry);
  MenisciBalance found = balance(inputs, film, on_liner, 0);
  if (found.excess < 0) {
    film.left.place = film.right.place = MeniscusPlace::kFree;
    found = balance(inputs, film, on_liner, 0);
  }
  const auto speed = [](const Meniscus& meniscus, const MeniscusMotion& motion) {
    return meniscus.place == MeniscusPlace::kFree ? motion.velocity : 0;
  };
  return speed(film.right, found.right) - speed(film.left, found.left);
}

MenisciBalance MenisciFilm::dry_balance(const MenisciInputs& inputs, const MenisciState& state,
                                        const OnLiner& on_liner) {
  const double h_m = std::exp(state.ln_h_m), x = state.left.x, width = grid_->width;
  MenisciBalance found;
  const double gas = inputs.left.pressure * x + inputs.right.pressure * (width - x);
  found.lift_rate = (gas + asperities_.load(h_m) - inputs.film.load) / squeeze_resistance(inputs, h_m);
  found.peak_pressure = std::max(inputs.left.pressure, inputs.right.pressure);
  found.excess = inputs.trailing().pressure - inputs.leading().pressure;
  found.passing = passing_throat(inputs, inputs.trailing(), h_m).at(found.excess);
  // Gas that blows with the motion holds nothing back, and behind the edge of the face there is no gap to be filled.
  const bool has_gap_behind = inputs.left_leads() ? x < width : x > 0;
  if (found.excess < 0 && !has_gap_behind) found.passing = kMaxEntering * (h_m + throat_.height);
  set_motion(inputs, state, on_liner, found);
  if (found.arriving > found.passing) found.growth = growth(inputs, state, on_liner);
  return found;
}

MenisciBalance MenisciFilm::balance(const MenisciInputs& inputs, const MenisciState& state, const OnLiner& on_liner,
                                    double rate, Iteration iteration) {
  if (state.is_dry()) return dry_balance(inputs, state, on_liner);
  const double h_m = std::exp(state.ln_h_m), width = grid_->width, U = std::abs(inputs.film.U);
  lay_points(inputs, state);
  const std::size_t n = points_.size(), throat = points_.at_place();
  const MenisciInputs::Edge &leading = inputs.leading(), &trailing = inputs.trailing();
  const bool left_leads = inputs.left_leads();
  const Meniscus &entering = left_leads ? state.left : state.right, &leaving = left_leads ? state.right : state.left;
  const bool is_blown_ahead = entering.place == MeniscusPlace::kAtThroat;
  const bool is_blown_behind = leaving.place == MeniscusPlace::kAtThroat;
  // Flows in the direction of the liner, over the film that passes: of the film that arrives, or of what passes the
  // gas.
  PassingFilm passes;
  if (is_blown_ahead) {
    MenisciBalance arriving;
    set_motion(inputs, state, on_liner, arriving);
    passes = {left_leads ? arriving.left.film : arriving.right.film, kUnlimitedHold};
  }
  const double wall = U * (is_blown_ahead ? leading : trailing).density;
  MenisciBalance found;
  found.lift_rate = rate;
  double film = passes.most;
  bool knows_passing = is_blown_ahead;
  const double resistance = squeeze_resistance(inputs, h_m);
  const double outside =
      inputs.left.pressure * state.left.x + inputs.right.pressure * (width - state.right.x) + asperities_.load(h_m);
  double entering_flow = 0;
  Outlet end{n};
  bool is_solved = false;
  for (int k = 0; k < kMaxIterations && !is_solved; ++k) {
    integrate_flow();
    const double D = found.lift_rate;
    const auto wedge = [&](std::size_t j) { return 6 * U * squares_[j] + 12 * D * squeezed_[j]; };
    const auto rise_of = [&](std::size_t j, double flow) {
      return 0.5 * U * trailing.density * points_.h()[j] + D * mass_[j] - flow;
    };
    double from = leading.reduced;  // reduced pressure at the leading meniscus
    bool is_held = is_blown_ahead || is_blown_behind;
    const bool is_outlet_sought = k < kPlainIterations && !is_blown_behind;
    if (is_blown_ahead) {
      entering_flow = wall * film;
      const auto reduced = [&](std::size_t j) { return wedge(j) - 12 * entering_flow * cubes_[j]; };
      const auto rise = [&](std::size_t j) { return 12 * rise_of(j, entering_flow) * inverse_cube_[j]; };
      end = is_outlet_sought ? outlet(reduced, rise, rise) : end_at(n - 1, reduced(n - 1));
      from = trailing.reduced - end.value;
    } else if (!is_blown_behind) {
      const double fall = leading.reduced - trailing.reduced;
      const auto flow_up_to = [&](std::size_t j) { return (fall + wedge(j)) / (12 * cubes_[j]); };
      const auto rise = [&](std::size_t j) { return rise_of(j, flow_up_to(j)) * inverse_cube_[j] / cubes_[j]; };
      const auto sense = [&](std::size_t j) { return 12 * cubes_[j] * rise_of(j, 0) - (fall + wedge(j)); };
      end = is_outlet_sought ? outlet(flow_up_to, rise, sense) : end_at(n - 1, flow_up_to(n - 1));
      entering_flow = end.value;
      // Gas blows through at the throat, whatever oil lies beyond it.
      is_held = end.is_at_throat && throat + 1 < n;
    } else {
      end = end_at(n - 1, 0);
    }
    const std::size_t last = end.beyond - 1;
    if (is_held && !is_blown_ahead) {
      if (!knows_passing) {
        passes = passing_throat(inputs, trailing, h_m);
        film = passes.most;
        knows_passing = true;
      }
      entering_flow = wall * film + D * mass_[last];
    }
    const double relaxation = k < kPlainIterations ? 1 : kRelaxation;
    const double by_cube = -12 * entering_flow, by_square = 6 * U, by_squeezed = 12 * D;
    for (std::size_t j = 0; j < end.beyond; ++j) {
      reduced_[j] = from + by_square * squares_[j] + by_squeezed * squeezed_[j] + by_cube * cubes_[j];
    }
    inputs.oil.at({reduced_.data(), end.beyond}, pressure_, slope_, density_);
    for (std::size_t j = 0; j < end.beyond; ++j) rho_[j] += relaxation * (density_[j] - rho_[j]);
    // Beyond the outlet the gap is still full of oil, which the liner drains.
    const double trailing_slope = end.beyond < n ? inputs.oil.at(trailing.reduced).slope : 0;
    for (std::size_t j = end.beyond; j < n; ++j) {
      pressure_[j] = trailing.pressure;
      slope_[j] = trailing_slope;
      rho_[j] = trailing.density;
    }
    // Of the load its slope in the reduced pressure, alone, times the squeezed film, and times the cubes.
    double load = outside, by_reduced = 0, of_squeezed = 0, of_cubes = 0;
    for (std::size_t j = 0; j < n; ++j) {
      const double weight = points_.weight()[j], share = j < end.beyond ? weight * slope_[j] : 0;
      load += weight * pressure_[j];
      by_reduced += share;
      of_squeezed += share * squeezed_[j];
      of_cubes += share * cubes_[j];
    }
    // What the reduced pressure changes by with dh_m/dt is 12 (squeezed - rate_from - rate_by_cube cubes), and with the
    // flow that passes the throat 12 (flow_from - cubes).
    const double rate_from = is_blown_ahead ? end.squeezed : 0, flow_from = is_blown_ahead ? end.cube : 0;
    const double rate_by_cube = is_blown_ahead ? 0 : is_held ? mass_[last] : end.squeezed / end.cube;
    const double by_rate = 12 * (of_squeezed - rate_from * by_reduced - rate_by_cube * of_cubes) - resistance;
    const double by_flow = is_held ? 12 * (flow_from * by_reduced - of_cubes) : 0;
    const double imbalance = load - resistance * D - inputs.film.load;
    double change_of_film = 0;
    if (is_held) {
      // At the throat the pressure of the film follows from the flow that passes, with the load in balance.
      const std::size_t held = is_blown_ahead ? 0 : last;
      const double p_by_rate = 12 * slope_[held] * (squeezed_[held] - rate_from - rate_by_cube * cubes_[held]);
      const double p_by_flow = 12 * slope_[held] * (flow_from - cubes_[held]);
      const double by_film = wall * (p_by_flow - p_by_rate * by_flow / by_rate);
      const double p = pressure_[held] - p_by_rate * imbalance / by_rate;
      const MenisciInputs::Edge& gas = is_blown_ahead ? leading : trailing;
      found.excess = passes.excess(gas.pressure - p + by_film * film, -by_film);
      const double next = passes.at(found.excess);
      change_of_film = next - film;
      film = next;
    }
    const double change = -(imbalance + by_flow * wall * change_of_film) / by_rate;
    found.lift_rate += change;
    if (is_blown_ahead) {
      entering_flow = wall * film;
    } else {
      entering_flow =
          is_held ? wall * film + found.lift_rate * mass_[last] : entering_flow + change * end.squeezed / end.cube;
    }
    if (!std::isfinite(change)) break;
    const double left_over = std::abs(change * by_rate) + std::abs(by_flow * wall * change_of_film);
    is_solved = left_over <= kTolerance * inputs.film.load || iteration == Iteration::kOnce;
  }
  if (!is_solved) {
    n_rho_ = 0;
    throw ConvergenceError(
        formatted("the film between its menisci does not balance the load of %.4g N per mm of circumference at %.4g um",
                  number_in(inputs.film.load, kNewtonPerMillimetre), number_in(h_m, kMicrometre)));
  }
  found.outlet = end.x;
  found.peak_pressure = *std::max_element(pressure_.begin(), pressure_.begin() + static_cast<std::ptrdiff_t>(n));
  // Oil that hangs behind the outlet gives way to a gap that closes, and does not follow one that opens.
  const double followed = found.lift_rate > 0 ? end.mass : mass_[n - 1];
  const double leaving_flow = entering_flow - found.lift_rate * followed;
  found.flow_left = left_leads ? entering_flow : -leaving_flow;
  found.flow_right = left_leads ? leaving_flow : -entering_flow;
  for (std::size_t j = 0; j < n; ++j) found.film_mass += points_.weight()[j] * rho_[j] * points_.h()[j];
  set_motion(inputs, state, on_liner, found);
  return found;
}

}  // namespace ringfilm::film
