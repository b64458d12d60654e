#pragma once
#include <cmath>
#include <memory>
#include <vector>

#include "ringfilm/film/solver/film_solver.hpp"
#include "ringfilm/film/solver/first_guess.hpp"
#include "ringfilm/models/contact/asperity_contact.hpp"
#include "ringfilm/models/oil/oil_fit.hpp"

/// Films as unlike as those that may meet in the lanes of a register.
namespace ringfilm::film::testing {

/// A ring's film and the steps through which it is to be taken.
struct LaneFilm {
  std::shared_ptr<const models::OilAtTemperature> oil;
  std::shared_ptr<const models::GreenwoodTripp> contact;
  FilmProblem problem;
  FilmState first;                ///< solved, steady
  std::vector<FilmInputs> steps;  ///< from there
};

/// What the films of one block have in common.
struct BlockKind {
  const FilmKernels* kernels;
  Cavitation cavitation;
  LaneLaws laws;
};

struct LaneFilmForm {
  int cells;
  double crown, apex;      ///< rise of the parabola [m], where it is lowest [-]
  double sigma;            ///< [m]
  double U;                ///< [m/s]
  double mean_pressure;    ///< [Pa]
  double oil_temperature;  ///< [K]
  ContactSpread spread = ContactSpread::kLocal;
};

/// @param temperature [K]; @param density as a multiple of the usual one [-]
inline std::shared_ptr<const models::OilAtTemperature> lane_oil(LaneLaws lane_laws, double temperature,
                                                                double density = 1) {
  models::OilLaws laws;
  laws.viscosity_temperature = {313.15, 373.15};
  laws.kinematic_viscosity = {60e-6, 9.6e-6};
  laws.density.temperature = {288.15, 313.15};
  laws.density.value = {850 * density, 834 * density};
  laws.parameters["pressure_viscosity_coefficient"] = 1e-8;
  laws.compression = models::DowsonHigginson{};
  const auto oil = models::closed_form_oil(laws, temperature);
  return lane_laws == LaneLaws::kFitted ? models::fitted_oil(oil, 0, 60e6) : oil;
}

inline LaneFilm lane_film(const BlockKind& kind, const LaneFilmForm& form) {
  constexpr double kWidth = 1.2e-3;  // [m]
  LaneFilm film;
  film.oil = lane_oil(kind.laws, form.oil_temperature);
  constexpr double kRadius = 1.5e-6;  // of the summits [m]
  film.contact = std::make_shared<models::GreenwoodTripp>(
      models::GreenwoodTripp::Parameters{0.05 / (kRadius * form.sigma), kRadius, form.sigma, 2.3e11});
  film.problem.grid = uniform_grid(form.cells, kWidth, [&](double x) {
    return form.crown * std::pow((x / kWidth - form.apex) / std::max(form.apex, 1 - form.apex), 2);
  });
  film.problem.contact = film.contact.get();
  film.problem.cavitation = kind.cavitation;
  film.problem.contact_spread = form.spread;
  film.problem.tolerance = 1e-10;
  film.problem.kernels = kind.kernels;

  FilmInputs inputs;
  inputs.oil = film.oil;
  inputs.U = form.U;
  inputs.left.pressure = 0.3 * form.mean_pressure + 1e5;
  inputs.right.pressure = 1.1e5;
  inputs.p_cavitation = 0.9e5;
  inputs.load = form.mean_pressure * kWidth;
  film.first = first_guess(film.problem, inputs);
  const FilmState guess = film.first;
  FilmWorkspace workspace(film.problem);
  if (!solve_film(film.problem, inputs, guess, film.first, workspace).converged) film.first.h_m = 0;
  for (int k = 1; k <= 4; ++k) {
    FilmInputs step = inputs;
    step.U *= 1 - 0.2 * k;
    step.load *= 1 + 0.02 * k * k;
    if (k == 3) step.p_cavitation = 0.8e5;
    step.time_step = 1e-4;
    film.steps.push_back(step);
  }
  return film;
}

/// Hard and easy, long and short; the third and the eighth are deep in contact at one end while the other end is far
/// out of its reach.
inline std::vector<LaneFilm> lane_films(const BlockKind& kind) {
  std::vector<LaneFilm> films;
  for (const LaneFilmForm& form : std::vector<LaneFilmForm>{
           {64, 8e-6, 0.4, 0.48e-6, 6, 9e5, 393},
           {100, 20e-6, 0.7, 0.3e-6, -9, 4e6, 353},
           {100, 200e-6, 0.05, 0.03e-6, 0.5, 5e5, 430},
           {40, 3e-6, 0.5, 1e-6, 2, 3e5, 330, ContactSpread::kNominal},
           {33, 15e-6, 0.2, 0.5e-6, 12, 2e5, 300},
           {100, 1e-6, 0.9, 0.1e-6, -3, 6e6, 420},
           {17, 60e-6, 0.6, 2e-6, 1, 1e6, 393},
           {100, 200e-6, 0.95, 0.03e-6, 0.5, 2e6, 430},
           {99, 10e-6, 0.5, 0.2e-6, -15, 8e5, 380, ContactSpread::kNominal},
           {64, 8e-6, 0.4, 0.48e-6, 0.05, 5e6, 440},
       }) {
    films.push_back(lane_film(kind, form));
  }
  return films;
}

/// The same film with a thinner and heavier oil in its second and third step, to a finer tolerance.
inline LaneFilm with_changing_oil(const BlockKind& kind, LaneFilm film, double temperature) {
  const auto other = lane_oil(kind.laws, temperature, 1.05);
  film.steps.at(1).oil = film.steps.at(2).oil = other;
  film.problem.tolerance = 1e-14;
  return film;
}

/// The same film with a load in its third step that nothing carries.
inline LaneFilm overloaded(LaneFilm film) {
  film.steps.at(2).load *= 1e4;
  return film;
}

}  // namespace ringfilm::film::testing
