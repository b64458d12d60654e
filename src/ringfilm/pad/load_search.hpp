#pragma once
#include <optional>

#include "ringfilm/pad/pad_film.hpp"

namespace ringfilm::pad {

/// How the load that a pad carries changes with separation at the target load.
enum class Slope {
  kFalling,  ///< falls as the film gets thicker: the pad comes back when it is pushed
  kRising,   ///< rises: in balance, but not stable
};

/// What a search among all separations for a load has found.
struct LoadSearch {
  std::optional<film::FilmState> film;  ///< nothing if no separation carries the load
  Slope slope = Slope::kFalling;        ///< there
  int n_separations = 0;                ///< at which the load is carried, as far as the search resolves them
  int n_stable = 0;                     ///< number of these at which the load falls with the separation
  /// Extreme of the load over all films that were tried [N/m], and the smallest film thickness of that film [m].
  struct Extreme {
    double load, thickness;
  };
  std::optional<Extreme> least, most;
  double thickest = 0, thinnest = 0;  ///< smallest film thickness of the films that were searched, from ... to [m]
  int n_unsolved = 0;                 ///< films of them that were not found
};

/// The steady film that carries `load` [N/m]. The load of a pad need not fall with its separation: films from the
/// pad's length down to a nanometre are tried, and of all that carry the load the thickest is taken at which it falls
/// with the separation, or, if there is none, the thickest. Counts into `effort`.
LoadSearch steady_film_under(PadFilms& films, double load, Effort& effort);

}  // namespace ringfilm::pad
