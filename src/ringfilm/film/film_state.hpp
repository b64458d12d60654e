#pragma once
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "ringfilm/film/edge.hpp"
#include "ringfilm/film/kernels/kernels.hpp"
#include "ringfilm/models/contact/contact_law.hpp"
#include "ringfilm/models/land/land_lift.hpp"
#include "ringfilm/models/oil/lubricant.hpp"

/// The plain structs that travel between the film and its callers. x runs along the face, the second surface moves with
/// +U in x; everything is per unit length around the ring.
namespace ringfilm::film {

enum class Cavitation {
  kReynoldsExit,    ///< p >= p_c, balance of mass holds where p > p_c (eq-complementarity)
  kMassConserving,  ///< p >= p_c, 0 <= theta <= 1, (p - p_c)(1 - theta) = 0 (eq-film-content)
};

/// Over which lambda ratio asperity contact is summed.
enum class ContactSpread {
  kLocal,    ///< lambda(x) = h(x)/sigma
  kNominal,  ///< lambda = h_m/sigma on the whole face
};

/// A piece of the gap between two places where it jumps: heights above the lowest point of the whole gap.
struct GapPiece {
  double begin = 0, end = 0;             ///< [m]
  std::function<double(double)> height;  ///< h_s(x) for begin <= x <= end [m]
};

/// A node at which the gap has two heights.
struct GapJump {
  int node;
  double height_left, height_right;  ///< h_s [m]
};

/// Nodes 0..n along the gap, n cells between them, uniform in each piece; a place where the gap jumps is a node, so
/// that between nodes it is continuous (eq-discrete-balance).
struct FilmGrid {
  double width = 0;                 ///< b [m]
  std::vector<double> x;            ///< nodes, from 0 to b, n+1 values [m]
  std::vector<double> spacing;      ///< from node i to node i+1, n values [m]
  std::vector<double> share;        ///< length of the gap that belongs to node i: half of each neighbouring cell [m]
  std::vector<double> node_height;  ///< h_s at the nodes; at a jump the mean over the node's share [m]
  std::vector<double> face_height;  ///< h_s midway between nodes i and i+1 [m]
  std::vector<GapJump> jumps;       ///< in the order of their nodes; mostly empty

  int n_cells() const { return static_cast<int>(face_height.size()); }
};
/// Computes `share` from `spacing`.
void complete_grid(FilmGrid& grid);

FilmGrid uniform_grid(int n_cells, double width, const std::function<double(double)>& height);

/// Do the cells suit the gap alone, or the gap turned over as well?
enum class Turning { kNever, kPossible };

/// Uniform cells, halved where the gap is so thin and so steep that a film of `thinnest` [m] at its lowest place would
/// change within one of them by more than about half of itself, eq-graded-cell. @param height above the lowest place of
/// the gap [m]
FilmGrid graded_grid(int n_cells, double width, const std::function<double(double)>& height, double thinnest,
                     Turning turning = Turning::kNever);

/// As many cells, whose lengths follow the root of the gap that a film of `reference` [m] has there, eq-cells-by-gap.
/// @param height above the lowest place of the gap [m]
FilmGrid grid_by_gap(int n_cells, double width, const std::function<double(double)>& height, double reference,
                     Turning turning = Turning::kNever);

/// A gap with jumps. The cells are shared among the pieces by their lengths, at least two each: the grid may have a few
/// more than asked for. @param pieces one after the other, the first from x = 0
FilmGrid grid_of_pieces(int n_cells, const std::vector<GapPiece>& pieces);

/// What does not change over a cycle. Referenced objects must outlive the problem.
struct FilmProblem {
  FilmGrid grid;
  const models::AsperityContact* contact = nullptr;  ///< nullptr: surfaces so smooth that they never touch
  const models::LandLift* land = nullptr;            ///< lift of the honing beside the film; nullptr: none
  Cavitation cavitation = Cavitation::kMassConserving;
  ContactSpread contact_spread = ContactSpread::kLocal;
  Terms terms = Terms::kPlain;  ///< kAll: the edges may be in gas, and the inputs may hold flow factors
  double tolerance = 0;         ///< relative error that the iteration may leave in film and pressure [-]
  const FilmKernels* kernels = &film::kernels();  ///< the inner loops that this machine runs
};

inline constexpr double kSteady = std::numeric_limits<double>::infinity();

/// By what a film differs from that of a Newtonian oil between smooth walls; held during a solve. Those of shear stress
/// only enter integrals. An empty list has no influence.
struct FlowFactors {
  std::vector<double> mobility;  ///< factor of the flow by pressure, at the nodes: 1 between smooth walls [-]
  /// Factor of the flow by pressure across the motion in a two-dimensional film, at the nodes [-]
  std::vector<double> mobility_across;
  std::vector<double> stored;  ///< by how much more oil the gap holds than its height, at the nodes [m]
  /// By how much more oil the wall carries through the faces than their height [m]
  std::vector<double> carried;
  std::vector<double> thinning;  ///< viscosity over that without shear, at the nodes [-]
  // eq-average-shear, at the faces
  std::vector<double> sliding_stress;     ///< factor of the stress by sliding, phi_f [-]
  std::vector<double> stress_difference;  ///< by which it is smaller on the moving wall, V_r Phi_fs [-]
  std::vector<double> pressure_stress;    ///< factor of the stress by pressure, phi_fp [-]
  std::vector<double> inverse_gap;        ///< mean of 1/h over that of a smooth gap; empty: sliding_stress has it [-]
};
inline constexpr std::vector<double> FlowFactors::*kFactorLists[] = {
    &FlowFactors::mobility,          &FlowFactors::mobility_across, &FlowFactors::stored,
    &FlowFactors::carried,           &FlowFactors::thinning,        &FlowFactors::sliding_stress,
    &FlowFactors::stress_difference, &FlowFactors::pressure_stress, &FlowFactors::inverse_gap};

/// What follows where Newton's method finds no film.
enum class Fallback {
  kSearch,  ///< a search over the separation, which takes a hundred times as long
  kNone     ///< the film counts as not found; across the face after 12 iterations
};

/// What acts on the film during one step.
struct FilmInputs {
  std::shared_ptr<const models::OilAtTemperature> oil;  ///< oil at the temperature of this step
  double U = 0;                                ///< velocity of the liner against the ring, positive in +x [m/s]
  EdgeState left, right;                       ///< at x = 0 and x = b
  double p_cavitation = 0;                     ///< not above either edge pressure [Pa]
  double load = 0;                             ///< W per length [N/m]
  double time_step = kSteady;                  ///< [s]
  std::shared_ptr<const FlowFactors> factors;  ///< nullptr: none
  double h_m_before = 0;  ///< film by which the narrowest stretch of the gap is found (GasReach); 0: unknown [m]
  BrokenFilm broken = BrokenFilm::kFreeSurface;
  double surface_tension = 0;  ///< oil against gas (eq-outlet); 0: half of the gap is left [N/m]
  std::optional<int> crest;    ///< node up to which a full film keeps the gases of both edges apart (GasReach)
  Fallback fallback = Fallback::kSearch;
  /// Mass that appears per length and time, at the nodes; empty: none. For manufactured solutions [kg/(m2 s)].
  std::vector<double> source;

  /// Mean pressure that the film and the asperities must carry: the scale of all pressures [Pa].
  double mean_pressure(const FilmGrid& grid) const { return load / grid.width; }

  /// Oil on the moving wall that can enter at an edge [kg/m2]: in time none where a film leaves into gas. A steady film
  /// takes there what it needs: the one from which an integration starts at a dead centre.
  double left_supply() const { return supply_at(left, U > 0); }
  double right_supply() const { return supply_at(right, U < 0); }
  bool is_steady() const { return time_step == kSteady; }
  bool has_gas() const { return left.fluid == EdgeFluid::kGas || right.fluid == EdgeFluid::kGas; }

 private:
  double supply_at(const EdgeState& edge, bool enters) const {
    return edge.fluid == EdgeFluid::kGas && !enters && !is_steady() ? 0 : edge.supply;
  }
};

/// The film at one instant; the start of the next step.
struct FilmState {
  double h_m = 0;               ///< minimum film thickness [m]
  std::vector<double> p;        ///< pressure at the nodes, absolute [Pa]
  std::vector<double> deficit;  ///< 0 where the film is full; 1 - theta, or the scaled multiplier of Reynolds exit [-]
  std::vector<double> mass_per_area;  ///< rho theta h at the nodes, what the squeeze term remembers [kg/m2]
  std::vector<double> ring;           ///< unknowns of a ring that bends (ElasticRing), over h_m; empty: none [m]
  std::vector<double> deformation;    ///< deformation of face and liner at the nodes (ElasticFace); empty: none [m]
  double tilt = 0;                    ///< tilt of the face (TiltingFace) [rad]
  LaneLaws laws = LaneLaws::kGiven;   ///< whose oil a solved film holds: kGiven, that of the laws themselves
  std::shared_ptr<const FlowFactors> factors;  ///< with which it was solved; nullptr: none
};

enum class Route { kNewton, kSecant };

/// How many iterations a film of a search may take.
enum class Patience { kLittle, kMuch };

/// Why a step has no solution.
enum class Failure {
  kNone,
  kOverloaded,    ///< film and asperities carry less than the load at any separation
  kLiftedOff,     ///< the film carries more than the load at any larger separation
  kRunsAway,      ///< films thinner than one that carries less than the load have no pressure: viscosity runs away
  kNotConverged,  ///< the iteration found none
};

/// How a step was solved.
struct FilmReport {
  bool converged = false;
  Failure failure = Failure::kNotConverged;  ///< kNone once converged
  Route route = Route::kNewton;
  bool exact_laws = false;   ///< solved with the laws themselves although the oil has fits: these do not reach so far
  int iterations = 0;        ///< Newton iterations, those of the fallback included
  long sweeps = 0;           ///< sweeps of point relaxation
  double last_step = 0;      ///< last relative change of film or pressure [-]
  double thinnest_film = 0;  ///< smallest h_m at which the film has a pressure, for kRunsAway [m]

  /// A film that was solved after this one, in its place: with the iterations of both.
  void add(const FilmReport& next);
};

}  // namespace ringfilm::film
