#pragma once
#include <string>
#include <tuple>
#include <vector>

#include "ringfilm/base/members.hpp"
#include "ringfilm/cycle/result/result.hpp"

/// What a pad gives: the film between a fixed pad of stated shape and a flat surface that moves past it. Everything is
/// per metre of width, the mean over it where it is finite, unless stated otherwise; SI. docs/theory/pad.md.
namespace ringfilm::pad {

/// Everything at one instant. x runs along the pad; flow is positive in +x, whichever way the flat surface moves.
/// Friction is shear, and that of asperities, positive where the oil brakes the moving surface and drags the pad along.
struct Sample {
  double time = 0;
  double load = 0, mean_film_pressure = 0, peak_film_pressure = 0, peak_position = 0;
  double separation = 0, min_film_thickness = 0;
  double friction_moving = 0, friction_fixed = 0, friction_coefficient = 0;  ///< coefficient: NaN without load
  double flow_left = 0, flow_right = 0;  ///< volume flow through both ends, of oil at its stated density
  double mass_flow_left = 0, mass_flow_right = 0;
  double cavitated_fraction = 0;             ///< without the gas of the edges
  double wetted_left = 0, wetted_right = 0;  ///< between them the film is full, but for cavities; else gas
  double film_load = 0, gas_load = 0;        ///< parts of the load: film on the wetted length, gas beyond it
  double asperity_load = 0;                  ///< part of the load on the asperities
  double boundary_friction = 0;              ///< part of both frictions by asperities; 0 at rest
  double film_left_behind = 0;               ///< on the flat surface where it leaves; NaN where it stands still
  double gas_breakthrough = 0;               ///< 1 where gas of an edge reaches the lowest place of the gap
  double stable_solutions = 0;               ///< separations that carry pad.load and are stable; NaN without it
  double journal_load = 0;                   ///< resultant of the film pressure around a journal; NaN without one
  double journal_load_angle = 0;             ///< its direction, from x = 0 towards +x [degree]; NaN without one
  double attitude_angle = 0;                 ///< from it to the lowest place of the gap [degree]; NaN without one
  double film_temperature = 0;               ///< NaN without temperatures of the walls
  /// Rise of the oil temperature by its shear, above its walls; NaN with a width
  double viscous_heating_rise = 0;
  double mass_residual = 0;  ///< balance of the whole film over the largest flow in it; round-off if mass is kept
  std::vector<double> rupture_positions;      ///< upstream ends of the cavities, from x = 0 on
  std::vector<double> reformation_positions;  ///< downstream ends; a cavity open to the downstream edge has none
  // with a width; the positions above are then those on the strip halfway across
  double total_load = 0;                                       ///< [N]
  double total_friction_moving = 0, total_friction_fixed = 0;  ///< [N]
  double flow_front = 0, flow_back = 0;                        ///< through the whole sides, +y [m3/s]; NaN where joined
  double mass_flow_front = 0, mass_flow_back = 0;              ///< through the whole sides, +y [kg/s]; NaN where joined
  double peak_position_y = 0;                                  ///< [m]
};

/// Name, unit and meaning of the numbers of a Sample, in the order of their importance.
struct PadQuantity : cycle::Quantity {
  double Sample::*value;
};
const std::vector<PadQuantity>& pad_quantities();
/// Those that only a pad with a width has.
const std::vector<PadQuantity>& width_quantities();

/// The lists of a Sample: places along the pad.
struct FrontQuantity : cycle::Quantity {
  std::vector<double> Sample::*value;
};
const std::vector<FrontQuantity>& front_quantities();

/// Film at one instant: along the pad, a value per entry of PadResult::x, or over it, so many for each of PadResult::y.
struct Profile {
  double time = 0;                     ///< [s]
  std::vector<double> film_thickness;  ///< [m]
  std::vector<double> pressure;        ///< [Pa]
  std::vector<double> film_content;    ///< theta [-]
};

/// The members of a profile, by the names of profile_quantities().
constexpr auto members(const Profile*) {
  return std::tuple{Member{"time", "s", "time", &Profile::time},
                    Member{"film_thickness", "m", "film thickness", &Profile::film_thickness},
                    Member{"pressure", "Pa", "film pressure, counted from the zero of the case", &Profile::pressure},
                    Member{"film_content", "1", "liquid share of the gap", &Profile::film_content}};
}

/// Time and the columns of a profile, named as in result files.
const std::vector<cycle::Quantity>& profile_quantities();
/// Place across the pad, as result files name it.
const cycle::Quantity& place_across();

struct Effort {
  long time_steps = 0;         ///< whole steps; 0 for a steady film
  long sub_steps = 0;          ///< solved, those that were cut included
  long newton_iterations = 0;  ///< Newton iterations of all solves
  long cut_steps = 0;          ///< steps that were solved only after they were cut
  long eased_starts = 0;       ///< steady films that were reached by raising the speed little by little
  double max_newton_step = 0;  ///< last relative Newton step accepted, the worst of all solves [-]
};

/// The members of the effort, as all outputs have them.
constexpr auto members(const Effort*) {
  return std::tuple{Member{"time_steps", "1", "whole steps", &Effort::time_steps},
                    Member{"sub_steps", "1", "steps solved, those that were cut included", &Effort::sub_steps},
                    Member{"newton_iterations", "1", "Newton iterations", &Effort::newton_iterations},
                    Member{"cut_steps", "1", "steps solved after they were cut", &Effort::cut_steps},
                    Member{"eased_starts", "1", "steady films reached by raising the speed", &Effort::eased_starts},
                    Member{"max_newton_step", "1", "largest Newton step accepted as the last one, relative",
                           &Effort::max_newton_step}};
}

struct PadResult {
  std::vector<Sample> samples;  ///< one for a steady film; else one for each time of the result, the last at the end
  std::vector<double> x;        ///< nodes, from 0 to the length; a step of the gap appears twice [m]
  /// Strips, from 0 to the width; a step of the gap appears twice; empty without a width [m]
  std::vector<double> y;
  std::vector<Profile> profiles;  ///< along x at the times of `samples`, with a width on the strip next to its middle
  std::vector<Profile> fields;    ///< over x and y at the same times; empty without a width
  std::vector<cycle::Note> notes;
  Effort effort;
  bool is_history = false;  ///< true: separation history, however far it came; false: steady film
  bool complete = true;     ///< false: the film could not be solved further; `samples` are those before
};

/// The single numbers of a result: without a width none of those of a width, with joined sides no flow through
/// them.
std::vector<PadQuantity> reported_quantities(const PadResult& result);

}  // namespace ringfilm::pad
