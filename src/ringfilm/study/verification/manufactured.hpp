#pragma once
#include <string>
#include <vector>

/// Manufactured solutions of the film's equation: pressure and separation are prescribed, the mass source that makes
/// them a solution is worked out by hand, and the solver must find them again @cite roache2002.
namespace ringfilm::study {

/// "steady" and "transient": a compressible, piezoviscous full film, the second with an oscillating separation; both
/// "in two dimensions" as well, with as many cells in y as in x.
const std::vector<std::string>& manufactured_films();

/// Largest error of pressure at the nodes (at the end of the integration), relative to the peak of the prescribed one
/// [-].
/// @param n_steps of backward Euler through a quarter of a period; without meaning for those that are steady
double manufactured_error(const std::string& film, int n_cells, int n_steps);

}  // namespace ringfilm::study
