#pragma once
#include "ringfilm/film/film_state.hpp"

namespace ringfilm::film {

/// A film whose separation is sought.
class FilmAtSeparation {
 public:
  virtual ~FilmAtSeparation() = default;
  /// Solves at this h_m from the last film that was solved, at first from the first guess; true if it converged.
  virtual bool solve_at(double h_m) = 0;
  /// W_h + W_a - W of the film as the last solve left it, converged or not [N/m].
  virtual double excess() const = 0;
};

struct SearchLimits {
  double thickest;   ///< [m]
  double load;       ///< W [N/m]
  double tolerance;  ///< [-]
};

/// Newton's method failed: the load carried falls with h_m, so that a bracket can be closed on it, in ln h_m. The film
/// is left solved where its load balances. Writes route and last step of the report, and the failure where film and
/// load end at the thinnest or the thickest film.
bool search_separation(FilmAtSeparation& film, double h_m, const SearchLimits& limits, FilmReport& report);

}  // namespace ringfilm::film
