#pragma once
#include <vector>

#include "ringfilm/film/film_state.hpp"

namespace ringfilm::film {

/// What the asperities of a face carry over its smallest film, eq-asperity-load, by cubics of the eighth root of the
/// load: the sum over the face once for each of their ends, and not at each film.
class AsperityCurve {
 public:
  explicit AsperityCurve(const FilmProblem& problem);

  double load(double h_m) const;  ///< per length of circumference [N/m]
  /// The film at which they carry a load, 0 where none is thin enough, the reach of the contact for no load [m].
  double film_under(double load) const;

 private:
  double spacing_ = 0;                ///< distance of the ends of the cubics [m]
  std::vector<double> root_, slope_;  ///< eighth root of the load, and its slope times the spacing [(N/m)^(1/8)]
};

}  // namespace ringfilm::film
