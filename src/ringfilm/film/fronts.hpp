#pragma once
#include <vector>

#include "ringfilm/film/film_state.hpp"

namespace ringfilm::film {

/// Where the film that ends at node `i` ends, near it and `outer`, the first node of the cavity
/// (docs/theory/film.md, "fronts between nodes") [m]. @param p of the nodes across the face [Pa]
/// @param ends_level the pressure comes to p_c without a slope, as ends_level() finds of a film
double front_position(const FilmGrid& grid, const double* p, double p_c, int i, int outer, bool ends_level);

/// Does a film end without a slope of pressure towards a cavity on its right, or else on its left? Where it ruptures,
/// and with Reynolds' exit also where it begins again.
bool ends_level(const FilmProblem& problem, const FilmInputs& inputs, bool cavity_on_right);

}  // namespace ringfilm::film
