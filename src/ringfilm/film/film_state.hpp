#pragma once
#include <functional>
#include <limits>
#include <vector>

#include "ringfilm/models/asperity_contact.hpp"
#include "ringfilm/models/lubricant.hpp"

/// The plain structs that travel between the film and its callers. x runs along the face, the second surface moves with
/// +U in x; everything is per unit length around the ring.
namespace ringfilm::film {

enum class Cavitation {
  kReynoldsExit,    ///< p >= p_c, balance of mass holds where p > p_c (eq-complementarity)
  kMassConserving,  ///< p >= p_c, 0 <= theta <= 1, (p - p_c)(1 - theta) = 0 (eq-fill)
};

/// Over which film parameter asperity contact is summed.
enum class ContactSpread {
  kLocal,    ///< lambda(x) = h(x)/sigma
  kNominal,  ///< lambda = h_m/sigma on the whole face
};

/// Uniform cells between nodes 0..n; heights of the face above its lowest point, exact at nodes and at cell faces.
struct FilmGrid {
  double width = 0;                 ///< b [m]
  double dx = 0;                    ///< [m]
  std::vector<double> node_height;  ///< h_s at x = i dx, n+1 values [m]
  std::vector<double> face_height;  ///< h_s at x = (i + 1/2) dx, n values [m]

  int n_cells() const { return static_cast<int>(face_height.size()); }
  double x(int i) const { return i * dx; }
};
FilmGrid uniform_grid(int n_cells, double width, const std::function<double(double)>& height);

/// What does not change over a cycle. Referenced objects must outlive the problem.
struct FilmProblem {
  FilmGrid grid;
  const models::OilAtTemperature* oil = nullptr;
  const models::GreenwoodTripp* contact = nullptr;
  Cavitation cavitation = Cavitation::kMassConserving;
  ContactSpread contact_spread = ContactSpread::kLocal;
  double tolerance = 0;  ///< relative error that the iteration may leave in film and pressure [-]
};

inline constexpr double kSteady = std::numeric_limits<double>::infinity();

/// What acts on the film during one step.
struct FilmInputs {
  double U = 0;                ///< velocity of the liner against the ring, positive in +x [m/s]
  double p_left = 0;           ///< pressure at x = 0, absolute [Pa]
  double p_right = 0;          ///< pressure at x = b, absolute [Pa]
  double p_cavitation = 0;     ///< not above either edge pressure [Pa]
  double load = 0;             ///< W per length [N/m]
  double time_step = kSteady;  ///< [s]

  /// Mean pressure that the film and the asperities must carry: the scale of all pressures [Pa].
  double mean_pressure(const FilmGrid& grid) const { return load / grid.width; }
};

/// The film at one instant; the start of the next step.
struct FilmState {
  double h_m = 0;                ///< minimum film thickness [m]
  std::vector<double> p;         ///< pressure at the nodes, absolute [Pa]
  std::vector<double> deficit;   ///< 0 where the film is full; 1 - theta, or the scaled multiplier of Reynolds exit [-]
  std::vector<double> content;   ///< rho theta h at the nodes, what the squeeze term remembers [kg/m2]
  std::vector<double> rho, eta;  ///< oil at the nodes of a solved film [kg/m3], [Pa s]
};

enum class Route { kNewton, kSecant };

/// Why a step has no solution.
enum class Failure {
  kNone,
  kOverloaded,    ///< film and asperities carry less than the load at any separation
  kNotConverged,  ///< the iteration found none
};

/// How a step was solved.
struct FilmReport {
  bool converged = false;
  Failure failure = Failure::kNotConverged;  ///< kNone once converged
  Route route = Route::kNewton;
  int iterations = 0;    ///< Newton iterations, those of the fallback included
  double last_step = 0;  ///< last relative change of film or pressure [-]
};

}  // namespace ringfilm::film
