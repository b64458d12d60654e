#pragma once
#include "ringfilm/film/factors/factor_iteration.hpp"
#include "ringfilm/film/solver/film_solver.hpp"
#include "ringfilm/pad/pad_film.hpp"

namespace ringfilm::pad {

/// The film of an infinitely wide pad: one strip.
class WideFilm : public PadFilm {
 public:
  WideFilm(const PadSetup& setup, int n_cells);

  const std::vector<double>& nodes() const override { return problem_.grid.x; }
  const std::vector<double>& strips() const override { return strips_; }
  double lowest_height() const override;

  film::FilmReport solve_at_separation(const film::FilmInputs& inputs, const film::FilmState& previous,
                                       film::FilmState& state) override;
  film::FilmReport solve(const film::FilmInputs& inputs, const film::FilmState& previous,
                         film::FilmState& state) override;

  film::FilmState full(double h_m) const override;
  double load(const film::FilmState& state) const override;
  Sample sample(const film::FilmInputs& inputs, const film::FilmState& previous, const film::FilmState& state,
                double time) const override;
  std::vector<double> places_x() const override;
  Profile profile(const film::FilmState& state, double time) const override;

 private:
  /// With the oil ahead of the inlet, for a film of `h_m`.
  film::FilmInputs supplied(film::FilmInputs inputs, double h_m) const;
  film::FilmReport solve_with_bounds(const film::FilmInputs& inputs, const film::FilmState& previous,
                                     film::FilmState& state);
  /// The node from which on a steady film falls below the pressure of its inlet, eq-pressure-bound; nothing: the gases
  /// meet on the narrowest stretch. @param inputs without one
  std::optional<int> crest(const film::FilmInputs& inputs, const film::FilmState& state) const;

  film::FilmProblem problem_;
  film::FactorIteration factors_;
  film::FilmWorkspace workspace_;
  std::vector<double> strips_{0.0};
};

}  // namespace ringfilm::pad
