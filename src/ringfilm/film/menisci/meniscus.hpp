#pragma once
#include <memory>

#include "ringfilm/film/film_state.hpp"
#include "ringfilm/film/menisci/reduced_pressure.hpp"

/// A film across a face between two menisci, beyond which gas lies on a film on the liner (docs/theory/menisci.md).
namespace ringfilm::film {

/// Where an end of the film is.
enum class MeniscusPlace {
  kFree,     ///< between the throat and the edge of the face; it moves
  kAtEdge,   ///< at the edge of the face, up to which the gap is full
  kAtThroat  ///< at the lowest place of the gap, since gas blows through there, or since there is no film
};

/// One end of the film.
struct Meniscus {
  double x = 0;  ///< [m]
  MeniscusPlace place = MeniscusPlace::kAtThroat;
};

/// The film at one instant: the unknowns of its ordinary differential equations, and where its ends are.
struct MenisciState {
  double ln_h_m = 0;  ///< logarithm of the smallest film thickness in metres
  Meniscus left, right;
  double bead = 0;  ///< oil ahead of the leading meniscus; below 0 it is taken from what comes next [kg/m]

  /// Is there no full film?
  bool is_dry() const { return left.place == MeniscusPlace::kAtThroat && right.place == MeniscusPlace::kAtThroat; }
};

/// What an inlet does not take.
enum class Surplus {
  kStays,  ///< it stays ahead as a bead, from which the inlet takes
  kIsLost  ///< the bead counts it, and the inlet takes nothing of it
};

/// What acts on the film at one instant.
struct MenisciInputs {
  /// @param film speed, edges, load and oil  @param highest_pressure that `oil` serves [Pa]
  MenisciInputs(FilmInputs film, double direction, Surplus surplus, double highest_pressure);

  /// The same with an oil that serves higher pressures.
  MenisciInputs served_up_to(double highest_pressure) const { return {film, direction, surplus, highest_pressure}; }

  FilmInputs film;
  double direction;  ///< 1: the liner moves in +x in this stroke; -1: in -x
  Surplus surplus;
  ReducedPressure oil;
  /// Gas at an edge, and the oil next to it.
  struct Edge {
    double pressure;  ///< absolute [Pa]
    double reduced;   ///< reduced pressure of the oil there [kg/(m3 s)]
    double density;   ///< [kg/m3]
  };
  Edge left, right;

  bool left_leads() const { return direction > 0; }  ///< does the liner come to the left meniscus?
  const Edge& leading() const { return left_leads() ? left : right; }
  const Edge& trailing() const { return left_leads() ? right : left; }
};

/// Oil on the liner next to both menisci [kg/m2].
struct OnLiner {
  double left = 0, right = 0;
};

/// A shorter film does not exist, and one that forms is twice as long [m].
inline constexpr double kMinFilmLength = 4e-6;

/// How a meniscus moves and what passes it.
struct MeniscusMotion {
  double velocity = 0;  ///< velocity of a free meniscus in its place [m/s]
  double film = 0;      ///< film on the liner that enters or that it leaves [m]
  bool leaves = false;  ///< does the liner carry oil out of the film?
};

/// The bead lies on so much of the liner [m].
inline constexpr double kBeadLength = 20e-6;
/// No film that enters fills more of the gap: a meniscus meets it at a finite speed [-].
inline constexpr double kMaxEntering = 0.8;

/// Law of a free meniscus, eq-meniscus. @param outward 1 at the right end, -1 at the left one
/// @param flow volume that flows in +x [m2/s]  @param U speed of the liner [m/s]  @param h gap [m]
/// @param on_liner film beyond the meniscus, with its bead [m]
MeniscusMotion meniscus_motion(double outward, double flow, double U, double h, double on_liner);

/// Film on the liner that passes the throat against gas, eq-broken-film [m].
struct PassingFilm {
  double most = 0;  ///< half of the gap [m]
  double held = 0;  ///< film times the root of the pressure of the gas over that of the film [m Pa^1/2]

  double at(double excess) const;  ///< @param excess of the pressure of the gas [Pa]
  /// The root of excess = lacking + resistance at(excess), which rises with it; negative where the film holds the gas.
  /// @param lacking [Pa]  @param resistance at least 0 [Pa/m]
  double excess(double lacking, double resistance) const;
};

/// What passes a throat of this length and gap. @param gas pressing from behind
PassingFilm passing_film(const MenisciInputs& inputs, const MenisciInputs::Edge& gas, double throat_length, double h);

}  // namespace ringfilm::film
