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
  film::FilmInputs supplied(film::FilmInputs inputs) const;  ///< with the oil ahead of the inlet
  film::FilmReport solve_with_bounds(const film::FilmInputs& inputs, const film::FilmState& previous,
                                     film::FilmState& state);
  /// The node at which the lower pressure bounds of the two edges meet, eq-pressure-bound.
  int meeting_of_bounds(const film::FilmInputs& inputs, const film::FilmState& state) const;

  film::FilmProblem problem_;
  int lowest_node_;
  film::FactorIteration factors_;
  film::FilmWorkspace workspace_;
  std::vector<double> strips_{0.0};
};

}  // namespace ringfilm::pad
