#pragma once
#include <vector>

#include "ringfilm/film/film_state.hpp"

namespace ringfilm::film {

/// Where the film that ends at node `i` ends, between it and `outer`, the first node of the cavity
/// (docs/theory/film.md, "fronts between nodes") [m]. @param p of the nodes across the face [Pa]
double front_position(const FilmGrid& grid, const double* p, double p_c, int i, int outer);

}  // namespace ringfilm::film
