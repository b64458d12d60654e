#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "ringfilm/film/film_state.hpp"
#include "ringfilm/pad/pad_grid_2d.hpp"
#include "ringfilm/pad/pad_result.hpp"
#include "ringfilm/pad/pad_setup.hpp"

namespace ringfilm::pad {

/// The film of a pad on one grid, of one dimension or two: what solves it, what it carries, what is reported of it. A
/// state of it holds strip after strip. Its inputs are PadSetup::steady_inputs() with a speed, a time step and a load;
/// the pressures at the sides come from the setup. Not for several threads at once.
class PadFilm {
 public:
  explicit PadFilm(const PadSetup& setup) : setup_(setup) {}
  PadFilm(const PadFilm&) = delete;
  PadFilm& operator=(const PadFilm&) = delete;
  virtual ~PadFilm() = default;

  const PadSetup& setup() const { return setup_; }

  virtual const std::vector<double>& nodes() const = 0;   ///< along x [m]
  virtual const std::vector<double>& strips() const = 0;  ///< along y; one where the pad is infinitely wide [m]
  virtual bool is_joined() const { return false; }        ///< is the last strip followed by the first?
  virtual double lowest_height() const = 0;               ///< that the grid sees, above the lowest of the gap [m]

  /// See film::solve_film_at_separation; @param inputs with the load as the scale of pressures
  virtual film::FilmReport solve_at_separation(const film::FilmInputs& inputs, const film::FilmState& previous,
                                               film::FilmState& state) = 0;
  /// See film::solve_film.
  virtual film::FilmReport solve(const film::FilmInputs& inputs, const film::FilmState& previous,
                                 film::FilmState& state) = 0;

  /// A film to start from at h_m [m]: edge pressures joined by a line, everything full.
  virtual film::FilmState full(double h_m) const = 0;
  /// eq-pad-load [N/m].
  virtual double load(const film::FilmState& state) const = 0;
  /// All numbers of a film solved with `inputs` from `previous`.
  virtual Sample sample(const film::FilmInputs& inputs, const film::FilmState& previous, const film::FilmState& state,
                        double time) const = 0;

  /// Places of nodes and of strips, a step of the gap twice; of strips none where the pad is infinitely wide [m].
  virtual std::vector<double> places_x() const = 0;
  virtual std::vector<double> places_y() const { return {}; }
  virtual Profile profile(const film::FilmState& state, double time) const = 0;
  /// Over x and y; nothing where the pad is infinitely wide.
  virtual std::optional<Profile> field(const film::FilmState&, double) const { return std::nullopt; }

  /// The film of a coarser grid as a guess on this one.
  film::FilmState guess_from(const PadFilm& coarse, const film::FilmState& solved) const;

 private:
  const PadSetup& setup_;
};

/// The film on a grid of about so many cells; refers to the setup.
std::unique_ptr<PadFilm> pad_film(const PadSetup& setup, Cells cells);

/// Films of one pad from a coarse grid to the finest, that of the case; refers to the setup.
class PadFilms {
 public:
  explicit PadFilms(const PadSetup& setup);

  PadFilm& finest() { return *films_.back(); }
  std::size_t n_levels() const { return films_.size(); }
  PadFilm& level(std::size_t k) { return *films_[k]; }

 private:
  std::vector<std::unique_ptr<PadFilm>> films_;
};

}  // namespace ringfilm::pad
