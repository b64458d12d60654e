#include "ringfilm/pad/solve_pad.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "ringfilm/base/display.hpp"
#include "ringfilm/base/table.hpp"
#include "ringfilm/pad/load_search.hpp"
#include "ringfilm/pad/pad_notes.hpp"
#include "ringfilm/pad/steady_film.hpp"

namespace ringfilm::pad {
namespace {

constexpr int kMaxHalvings = 6;  // a time step is cut to 1/64 at the finest

/// Viscosity of the oil at no pressure [Pa s], and its slope over pressure [s].
struct Viscosity {
  double eta = 0, deta_dp = 0;
};
Viscosity viscosity(const PadSetup& setup) {
  const double p = 0;
  double rho = 0, drho_dp = 0;
  Viscosity oil;
  setup.oil->properties({&p, 1}, {{&rho, 1}, {&drho_dp, 1}, {&oil.eta, 1}, {&oil.deta_dp, 1}});
  return oil;
}

/// The largest pressure that edges, sides and motion can make in a steady film, but for a factor of order 1 [Pa].
double acting_pressure(const PadSetup& setup, double h_m) {
  const cycle::Pad& pad = setup.input.pad;
  const double edges = std::max(std::abs(pad.left_pressure), std::abs(pad.right_pressure));
  const double sides =
      pad.has_sides_at_pressures() ? std::max(std::abs(pad.front_pressure), std::abs(pad.back_pressure)) : 0.0;
  return std::max({edges, sides, viscosity(setup).eta * std::abs(setup.U) * pad.length / (h_m * h_m)});
}

/// A steady film in which nothing acts has no pressure and no flow: what the solver leaves of them is rounding.
void clear_rounding(Sample& sample) {
  for (double Sample::*value :
       {&Sample::load, &Sample::mean_film_pressure, &Sample::peak_film_pressure, &Sample::friction_moving,
        &Sample::friction_fixed, &Sample::flow_left, &Sample::flow_right, &Sample::mass_flow_left,
        &Sample::mass_flow_right, &Sample::total_load, &Sample::total_friction_moving, &Sample::total_friction_fixed,
        &Sample::flow_front, &Sample::flow_back, &Sample::mass_flow_front, &Sample::mass_flow_back,
        &Sample::journal_load}) {
    if (!std::isnan(sample.*value)) sample.*value = 0;
  }
  sample.load = sample.asperity_load;
  for (double Sample::*value : {&Sample::friction_coefficient, &Sample::journal_load_angle, &Sample::attitude_angle}) {
    sample.*value = std::numeric_limits<double>::quiet_NaN();
  }
}

void append_instant(const PadFilm& film, const film::FilmInputs& inputs, const film::FilmState& previous,
                    const film::FilmState& state, double time, PadResult& result) {
  result.samples.push_back(film.sample(inputs, previous, state, time));
  const bool is_steady = inputs.time_step == film::kSteady;
  if (is_steady && acting_pressure(film.setup(), state.h_m) == 0) clear_rounding(result.samples.back());
  result.profiles.push_back(film.profile(state, time));
  if (auto field = film.field(state, time)) result.fields.push_back(std::move(*field));
}

/// Separation of the history or of the oscillation [m].
double separation_at(const cycle::Pad& pad, double time) {
  const auto& [amplitude, period, phase_deg] = pad.oscillation;
  if (!amplitude) return interpolate_linear(pad.history_time, pad.history_separation, time);
  return *pad.separation + *amplitude * std::cos(2 * std::numbers::pi * (time / period + phase_deg / 360));
}

/// The film through time, one whole step after the other.
class TimeIntegration {
 public:
  TimeIntegration(PadFilm& film, film::FilmState start, PadResult& result)
      : film_(film), setup_(film.setup()), state_(std::move(start)), result_(result) {}

  void run(Observer* observer) {
    const cycle::Pad& pad = setup_.input.pad;
    const double begin = pad.first_time(), end = pad.last_time(), dt = pad.time_step;
    const long n_steps = std::max(1L, static_cast<long>(std::ceil((end - begin) / dt - kRounding)));
    const long every = pad.output_step ? std::lround(*pad.output_step / dt) : 1;
    for (long k = 1; k <= n_steps; ++k) {
      const double from = begin + static_cast<double>(k - 1) * dt;
      const double to = k == n_steps ? end : begin + static_cast<double>(k) * dt;
      if (!advance(from, to, 0)) {
        append_notes(film_, result_);
        throw StoppedPad(formatted("between %.6g s and %.6g s no film was found, with 1/%d of the time step either",
                                   from, to, 1 << kMaxHalvings),
                         std::move(result_));
      }
      ++result_.effort.time_steps;
      if (k % every == 0 || k == n_steps) {
        append_instant(film_, inputs_, before_, state_, to, result_);
      }
      if (observer != nullptr) observer->advanced(to, end);
    }
  }

 private:
  static constexpr double kRounding = 1e-9;  // share of a step: remainder of the division of times

  double h_m_at(double time) const { return separation_at(setup_.input.pad, time) + setup_.lowest_gap; }

  bool advance(double from, double to, int halvings) {
    if (solve(from, to)) return true;
    if (halvings == 0) ++result_.effort.cut_steps;
    if (halvings == kMaxHalvings) return false;
    const double middle = 0.5 * (from + to);
    return advance(from, middle, halvings + 1) && advance(middle, to, halvings + 1);
  }

  bool solve(double from, double to) {
    film::FilmInputs inputs = setup_.steady_inputs();
    inputs.time_step = to - from;
    const double h_m = h_m_at(to);
    const double closing = (h_m_at(from) - h_m) / inputs.time_step;
    // From where the film was, or else from a full one.
    for (film::FilmState next : {state_, film_.full(h_m)}) {
      next.h_m = h_m;
      if (!solve_at_separation(film_, inputs, closing, state_, next, result_.effort)) continue;
      ++result_.effort.sub_steps;
      inputs_ = inputs;
      before_ = std::move(state_);
      state_ = std::move(next);
      return true;
    }
    return false;
  }

  PadFilm& film_;
  const PadSetup& setup_;
  film::FilmState state_, before_;
  film::FilmInputs inputs_;
  PadResult& result_;
};

/// Does a film one per cent thicker carry the same? Then the load does not determine the separation.
bool any_separation_carries(PadFilms& films, const film::FilmState& state, Effort& effort) {
  constexpr double kThicker = 1.01, kTheSame = 1e-10;
  PadFilm& film = films.finest();
  const auto thicker = steady_film_at(films, kThicker * state.h_m - film.setup().lowest_gap, effort);
  const double load = film.load(state);
  return thicker && std::abs(film.load(*thicker) - load) <= kTheSame * load;
}

/// Why no film is found where viscosity grows with pressure; empty where it does not.
std::string limit_of_pressure(const PadSetup& setup) {
  const auto [eta, deta_dp] = viscosity(setup);
  if (!(deta_dp > 0)) return "";
  return formatted(
      "; where viscosity grows with pressure there is no film above a pressure of about 1/alpha = %.3g bar as a "
      "constant viscosity would make it",
      number_in(eta / deta_dp, kBar));
}

std::string no_film_at(const PadSetup& setup) {
  std::string message = "no steady film was found, from slower motion and coarser grids either";
  const std::string limit = limit_of_pressure(setup);
  return limit.empty() ? message : message + limit + ": take a larger separation";
}

std::string no_film_under(const PadSetup& setup, double load, const LoadSearch& search) {
  std::string message = formatted(
      "no separation was found at which the film carries %.6g N/m; films were searched from %.4g um, the length "
      "of the pad, to %.4g um, that of molecules",
      load, number_in(search.thickest, kMicrometre), number_in(search.thinnest, kMicrometre));
  if (search.n_unsolved > 0) message += formatted(", of which %d were not found", search.n_unsolved);
  if (!search.most) return message;
  if (search.least->load == search.most->load) {
    return message +
           formatted("; each carries %.6g N/m: the gap makes no pressure of its own in this direction of motion",
                     search.most->load);
  }
  const auto [least, thickness_of_least] = *search.least;
  const auto [most, thickness_of_most] = *search.most;
  message +=
      formatted("; the largest load is %.6g N/m (smallest film %.4g um), the smallest one %.6g N/m (%.4g um)", most,
                number_in(thickness_of_most, kMicrometre), least, number_in(thickness_of_least, kMicrometre));
  if (search.n_unsolved > 0) message += limit_of_pressure(setup);
  if (load > least && load < most) {
    message +=
        "; between these loads the film jumps or was not found: take other solver.cells, or state pad.separation";
  }
  return message;
}

/// What must be known of a separation that was found for a load.
void append_load_notes(const LoadSearch& search, std::vector<cycle::Note>& notes) {
  if (search.slope == Slope::kRising) {
    notes.push_back({"load-rises-with-separation",
                     "where the load is carried it rises with the separation: in balance, but a pad that is free to "
                     "move would leave it"});
  }
  if (search.n_separations > 1) {
    notes.push_back({"load-at-several-separations",
                     "the load is carried at more than one separation: the thickest film is taken at which it falls "
                     "with the separation",
                     search.n_separations});
  }
}

/// A steady film with half the cells, to check whether the grid is fine enough.
void append_grid_note(const PadSetup& setup, const film::FilmState& state, const Sample& fine, PadResult& result) {
  constexpr double kZeroLoad = 1e-9;  // share of the pressures that act: a share of a smaller load is not meaningful
  if (std::abs(fine.load) <= kZeroLoad * acting_pressure(setup, state.h_m) * setup.input.pad.length) return;
  constexpr double kReportedChange = 0.01;
  const cycle::Solver& solver = setup.input.solver;
  const auto film = pad_film(setup, {(solver.cells + 1) / 2, (solver.cells_y + 1) / 2});
  film::FilmState coarse = film->full(state.h_m);
  const film::FilmState before = coarse;
  if (!solve_at_separation(*film, setup.steady_inputs(), 0, before, coarse, result.effort)) return;
  const double change = film->load(coarse) / fine.load - 1;
  if (!(std::abs(change) > kReportedChange)) return;
  result.notes.push_back(
      {"coarse-grid", formatted("with half the cells the same film carries %.2g %% %s: take more %s",
                                std::abs(100 * change), change > 0 ? "more" : "less", cell_keys(setup))});
}

/// A film, and how many others there are.
struct FirstFilm {
  film::FilmState state;
  double stable_solutions;  ///< separations that carry the load; NaN where the separation is stated
};

/// The steady film that the case asks for, or the one that a history starts from.
FirstFilm first_film(PadFilms& films, PadResult& result) {
  const PadSetup& setup = films.finest().setup();
  const cycle::Pad& pad = setup.input.pad;
  const auto stop = [&](const std::string& message) {
    append_notes(films.finest(), result);
    throw StoppedPad(message, std::move(result));
  };
  if (!pad.load) {
    const double separation = result.is_history ? separation_at(pad, pad.first_time()) : *pad.separation;
    auto film = steady_film_at(films, separation, result.effort);
    if (!film) stop(no_film_at(setup));
    return {*film, std::numeric_limits<double>::quiet_NaN()};
  }
  LoadSearch search = steady_film_under(films, *pad.load, result.effort);
  if (!search.film) stop(no_film_under(setup, *pad.load, search));
  if (any_separation_carries(films, *search.film, result.effort)) {
    stop(formatted(
        "any separation carries the load of %.6g N/m: the pressures at the edges do, and the gap makes none of "
        "its own; state pad.separation",
        *pad.load));
  }
  append_load_notes(search, result.notes);
  return {*search.film, static_cast<double>(search.n_stable)};
}

}  // namespace

PadResult solve_pad(const cycle::Case& c, Observer* observer) {
  const PadSetup setup = prepare_pad(c);
  PadFilms films(setup);
  PadFilm& film = films.finest();
  PadResult result;
  result.complete = false;
  result.is_history = c.pad.is_transient();
  result.x = film.places_x();
  result.y = film.places_y();
  const auto [start, stable_solutions] = first_film(films, result);
  const double begin = result.is_history ? c.pad.first_time() : 0.0;
  append_instant(film, setup.steady_inputs(), start, start, begin, result);
  result.samples.back().stable_solutions = stable_solutions;
  if (result.is_history) {
    TimeIntegration(film, start, result).run(observer);
  } else {
    append_grid_note(setup, start, result.samples.back(), result);
  }
  result.complete = true;
  append_notes(film, result);
  return result;
}

}  // namespace ringfilm::pad
