#pragma once
#include "ringfilm/film/integrals/film2d_integrals.hpp"
#include "ringfilm/film/solver2d/film2d_solver.hpp"
#include "ringfilm/pad/pad_film.hpp"
#include "ringfilm/pad/pad_grid_2d.hpp"

namespace ringfilm::pad {

/// The film of a pad of finite width.
class PadFilm2d : public PadFilm {
 public:
  PadFilm2d(const PadSetup& setup, Cells cells);

  const std::vector<double>& nodes() const override { return problem_.strip.grid.x; }
  const std::vector<double>& strips() const override { return problem_.around.y; }
  bool is_joined() const override { return problem_.around.ends == film::Ends::kJoined; }
  double lowest_height() const override { return grid_.lowest; }

  film::FilmReport solve_at_separation(const film::FilmInputs& inputs, const film::FilmState& previous,
                                       film::FilmState& state) override;
  film::FilmReport solve(const film::FilmInputs& inputs, const film::FilmState& previous,
                         film::FilmState& state) override;

  film::FilmState full(double h_m) const override;
  double load(const film::FilmState& state) const override;
  Sample sample(const film::FilmInputs& inputs, const film::FilmState& previous, const film::FilmState& state,
                double time) const override;
  std::vector<double> places_x() const override;
  std::vector<double> places_y() const override;
  Profile profile(const film::FilmState& state, double time) const override;
  std::optional<Profile> field(const film::FilmState& state, double time) const override;

 private:
  /// A strip as it is reported: seen from the cells on one side of it.
  struct Row {
    int strip, cell;
    double y;  ///< [m]
  };
  std::vector<Row> rows() const;
  void append_row(const film::FilmState& state, const Row& row, Profile& to) const;
  film::Film2dInputs inputs_of(const film::FilmInputs& inputs) const;
  double largest_flux(const film::FilmInputs& inputs, const film::FilmState& state,
                      const film::Film2dIntegrals& sums) const;
  void add_peak(const film::FilmState& state, Sample& sample) const;

  PadGrid2d grid_;
  film::Film2dProblem problem_;
  film::Film2dWorkspace workspace_;
};

}  // namespace ringfilm::pad
