#pragma once
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <numbers>

#include "film_cases.hpp"

/// Steady films between gas, or between oil and gas, by quadrature of Reynolds' equation on its full film: it begins at
/// x_1 with the pressure of the entry, and ends at x_2, where the gap is h* = 2 q/U, without a slope of pressure (eq.
/// eq-gas-film). A parabolic face, constant oil; shares no code with the solver.
namespace ringfilm::film::testing {

/// By Simpson's rule, to rounding for these films.
template <class Function>
double integral(const Function& f, double a, double b) {
  constexpr int kIntervals = 4000;
  const double step = (b - a) / kIntervals;
  double sum = f(a) + f(b);
  for (int k = 1; k < kIntervals; ++k) sum += (k % 2 == 1 ? 4 : 2) * f(a + k * step);
  return sum * step / 3;
}

struct GasFilm {
  double width = 1.2e-3, crown = 10e-6;  // [m]
  double eta = 5e-3, U = 6.5;            // [Pa s], [m/s]
  double p_in = 1e5, p_out = 20e5;       // [Pa]
  double h_m = 1e-6;                     // [m]
  double apex = 0.5;                     // place of the lowest gap [-]
  double h_star = 0;                     // twice the film that enters [m]
  double begin = 0, end = 0;             // x_1, x_2 [m]

  double height(double x) const { return h_m + crown * std::pow(2 * (x / width - apex), 2); }
  double slope(double x) const { return 6 * eta * U * (height(x) - h_star) / std::pow(height(x), 3); }
  /// Rise of pressure from a to b [Pa].
  double rise(double a, double b) const {
    return integral([this](double x) { return slope(x); }, a, b);
  }
  double exit_of(double h) const { return 0.5 * width * (1 + std::sqrt((h - h_m) / crown)); }
  double load() const {  // by parts: each rise of pressure acts from there to the end of the film
    const double film = integral([this](double x) { return (end - x) * slope(x); }, begin, end);
    return p_in * end + film + p_out * (width - end);
  }
};

template <class Function>
double root_of(const Function& f, double low, double high) {
  boost::uintmax_t evaluations = 200;
  const auto [a, b] =
      boost::math::tools::toms748_solve(f, low, high, boost::math::tools::eps_tolerance<double>(50), evaluations);
  return 0.5 * (a + b);
}

/// A film of `supply` [m] comes on the liner.
inline GasFilm starved(double supply) {
  GasFilm film;
  film.h_star = 2 * supply;
  film.end = film.exit_of(film.h_star);
  // Outwards from where the gap is h* the film gains pressure: the least one that the exit asks for.
  const double inner = film.width - film.end;
  film.begin = root_of([&](double x) { return film.rise(x, film.end) - (film.p_out - film.p_in); }, 0, inner);
  return film;
}

/// Oil fills the entry.
inline GasFilm flooded() {
  GasFilm film;
  const auto lacking = [&film](double h_star) {
    film.h_star = h_star;
    film.end = film.exit_of(h_star);
    return film.rise(0, film.end) - (film.p_out - film.p_in);
  };
  film.h_star = root_of(lacking, 1.0001 * film.h_m, 3 * film.h_m);
  lacking(film.h_star);
  return film;
}

/// Oil fills the entry, and gas blows through the lowest place, eq-broken-film.
inline GasFilm broken(double apex) {
  GasFilm film;
  film.apex = apex;
  film.p_out = 250e5;
  film.end = apex * film.width;
  const double length = 8 / (3 * std::numbers::pi) *
                        integral([&](double x) { return std::pow(film.h_m / film.height(x), 3); }, 0, film.width);
  film.h_star = root_of(
      [&](double h_star) {
        film.h_star = h_star;
        const double held = film.p_out - film.p_in - film.rise(0, film.end);
        return h_star * h_star * held - 16.0 / 9 * film.eta * film.U * length;
      },
      0, film.h_m);
  return film;
}

inline FilmInputs inputs_of(const GasFilm& film, const SmoothFilm& smooth) {
  FilmInputs inputs = smooth.inputs();
  inputs.U = film.U;
  inputs.load = film.load();
  inputs.h_m_before = film.h_m;
  inputs.p_cavitation = film.p_in;
  inputs.left.pressure = film.p_in;
  if (film.begin > 0) {
    inputs.left.fluid = EdgeFluid::kGas;
    inputs.left.supply = film.h_star / 2;  // density 1
  }
  inputs.right = {film.p_out, EdgeFluid::kGas};
  return inputs;
}

/// The same with entry and exit exchanged.
inline FilmInputs mirrored(FilmInputs inputs) {
  inputs.U = -inputs.U;
  std::swap(inputs.left, inputs.right);
  return inputs;
}

/// The film as the solver has it, on cells.
inline SmoothFilm film_of(const GasFilm& form, int n_cells) {
  SmoothFilm film(
      n_cells, form.width, [&](double x) { return form.height(x) - form.h_m; }, form.eta, Cavitation::kMassConserving);
  film.problem.terms = Terms::kAll;
  return film;
}

}  // namespace ringfilm::film::testing
