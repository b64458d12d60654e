#pragma once
#include <vector>

#include "ringfilm/film/film2d.hpp"
#include "ringfilm/film/film_state.hpp"
#include "ringfilm/pad/gap_surface.hpp"

namespace ringfilm::pad {

/// Cells along the motion, and across it where the width is finite.
struct Cells {
  int along = 0, across = 0;
};

/// A gap on nodes, eq-pad-film-2d. Steps of the gap lie on nodes in both directions.
struct PadGrid2d {
  film::FilmGrid grid;                      ///< along x; without heights
  film::CircumferentialGrid around;         ///< strips across
  film::Film2dGap gap;                      ///< above the lowest point
  std::vector<int> steps_x, steps_y;        ///< nodes and strips at which the gap may step
  std::vector<int> piece_of_x, piece_of_y;  ///< piece of the gap that each cell belongs to
  double lowest = 0;                        ///< height that the grid sees [m]
};

/// The grid of a gap of about so many cells, shared among its pieces by length, at least two each.
PadGrid2d pad_grid_2d(const GapSurface& surface, Cells cells, film::Ends ends);

}  // namespace ringfilm::pad
