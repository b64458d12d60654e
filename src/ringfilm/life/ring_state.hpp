#pragma once
#include <optional>
#include <tuple>
#include <vector>

#include "ringfilm/base/members.hpp"
#include "ringfilm/life/life.hpp"

/// What changes of a ring over its life, and its interpolation between measured states (docs/theory/life.md).
namespace ringfilm::life {

/// What opened the end gap of a ring since the start of its life.
struct EndGapWear {
  double ring_depth = 0;            ///< largest worn depth of the face [m]
  std::vector<double> liner_depth;  ///< along the stroke [m]; empty: the liner is not followed
};

/// Face, roughness and boundary shear strength of a ring at a running time.
struct RingState {
  cycle::RingFace face;         ///< the shape over its width
  double asperity_density = 0;  ///< N [1/m2]
  double asperity_radius = 0;   ///< beta [m]
  double roughness = 0;         ///< sigma, by its measure [m]
  cycle::RoughnessMeasure roughness_measure = cycle::RoughnessMeasure::kAsGiven;
  double boundary_shear_strength_coefficient = 0;  ///< zeta [-]
  EndGapWear gap = {};                             ///< with the face; used where a pack is given
  std::optional<double> Rpq = {};                  ///< rms of the plateau; nothing: that of the case [m]
};

/// The numbers of the contact, as all outputs have them.
constexpr auto members(const RingState*) {
  return std::tuple{Member{"asperity_density", "m-2", "asperity peaks per area", &RingState::asperity_density, "N"},
                    Member{"asperity_radius", "m", "mean radius of the peaks", &RingState::asperity_radius, "beta"},
                    Member{"roughness", "m", "composite roughness", &RingState::roughness, "sigma"},
                    Member{"boundary_shear_strength_coefficient", "1", "coefficient of boundary shear strength",
                           &RingState::boundary_shear_strength_coefficient, "zeta"}};
}

/// Which of the three a mixture takes from a later state.
enum class Part { kFace, kRoughness, kShearStrength };

/// How a state at a running time is known.
enum class StateOrigin {
  kMeasured,      ///< it is one of the measured states
  kInterpolated,  ///< between two of them
  kHeld,          ///< after the last one, whose values it keeps
  kScenario       ///< its face follows from an assumed or tuned wear coefficient
};

RingState ring_state_of(const cycle::Case& c);  ///< state of the ring of a case

/// The case with another ring in it.
cycle::Case with_ring_state(cycle::Case c, const RingState& state);

/// The roughness of a case that runs in: Rpq of its plateau, else contact.roughness [m]. Not of a table.
double run_in_roughness(const cycle::Case& c);

/// The ring of a case whose peaks have another roughness: heights are scaled, distances between the peaks kept, so
/// that N stays and beta sigma stays, eq-life-run-in-asperities. At the roughness of the case it is that of the case,
/// to the bit. @param roughness as run_in_roughness() has it [m]
RingState run_in_state(const cycle::Case& c, double roughness);

/// Least depth scale with which peaks lose no more than what is worn, eq-life-run-in-volume [m].
/// @param limit of the roughness, as run_in_roughness() has it [m]
double least_depth_scale(const cycle::Case& c, double limit);

RingState turned(RingState state);  ///< its two edges exchanged; one that turns over at each reversal as it is

/// The earlier state with one part of the later one.
RingState with_part(RingState earlier, const RingState& later, Part part);

/// Between two states of rings of one width: the face linear at each place, counted from the lowest points of both; N,
/// beta, sigma and zeta linear in their logarithms, eqs eq-life-face, eq-life-moments.
/// @param share of the later state, 0 to 1 @param cells across the face; they define where faces of points are taken
RingState interpolated(const RingState& earlier, const RingState& later, double share, double width, int cells);

/// How far a running time is from one state to the next: eq-life-share, 0 to 1.
double path_share(const Interpolation& path, double from, double to, double time);

/// How the state at a running time is known.
StateOrigin state_origin_at(const std::vector<MeasuredState>& states, double time);

/// The ring at a running time on the path between the states; after the last one its values are held. At the running
/// time of a state it is that state, to the bit. Throws std::invalid_argument before the first state.
RingState state_on_path(const std::vector<MeasuredState>& states, const Interpolation& path, double time, int cells);

}  // namespace ringfilm::life
