#pragma once

namespace ringfilm::study {

/// Largest error of pressure at the nodes of a manufactured film in two dimensions (at the end of the integration),
/// relative to the peak of the prescribed one [-]. Strips crowd towards one end, so that uneven cells are tried as
/// well.
/// @param n_cells in x, and as many in y
/// @param n_steps of backward Euler through a quarter of a period; 0: steady
double manufactured_film2d_error(int n_cells, int n_steps);

}  // namespace ringfilm::study
