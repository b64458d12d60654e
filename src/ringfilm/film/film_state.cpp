#include "ringfilm/film/film_state.hpp"

namespace ringfilm::film {

FilmGrid uniform_grid(int n_cells, double width, const std::function<double(double)>& height) {
  FilmGrid grid;
  grid.width = width;
  grid.dx = width / n_cells;
  for (int i = 0; i <= n_cells; ++i) grid.node_height.push_back(height(width * i / n_cells));
  for (int i = 0; i < n_cells; ++i) grid.face_height.push_back(height(width * (i + 0.5) / n_cells));
  return grid;
}

}  // namespace ringfilm::film
