#pragma once
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/base/error.hpp"
#include "ringfilm/case/case.hpp"

/// The life of a ring: measured states at their running hours, and what friction, oil and film are over hours
/// (docs/theory/life.md). One plain value in SI; its defaults are written here.
namespace ringfilm::life {

inline constexpr double kHour = 3600;  ///< [s]
/// Longest running time of a life [s]: a million hours, more than a century.
inline constexpr double kMaxTime = 3.6e9;
/// Depth at which a scenario of wear ends where nothing states a coating: a usual one of molybdenum [m].
inline constexpr double kAssumedCoating = 100e-6;
/// More jumps than a life can need: a coating of 1 mm takes a tenth.
inline constexpr int kMaxJumps = 100'000;
/// No scan measures a face better than to some nanometres, nor does a depth below the size of an atom mean anything. A
/// jump of this depth takes a usual coating off in kMaxJumps [m].
inline constexpr double kMinJumpDepth = 1e-9;
/// The two stages of a jump differ with the square of its length: at this difference jumps are a tenth of the usual
/// ones [m].
inline constexpr double kMinJumpError = 1e-10;
/// Wear coefficient above which each contact would remove more than all that it touches, 1/(3H), for any metal [m2/N].
inline constexpr double kMaxCoefficient = 1e-9;

std::string hours_text(double time);  ///< a running time [s] as messages show it: "10 h"

/// Where face, roughness and shear strength come from over the running time.
enum class Mode {
  kMeasuredPath,  ///< interpolated between measured states
  kArchard  ///< a scenario: the face wears by asperity pressure and sliding, the surface as `Wear::surface` has it
};

/// How the running time enters an interpolation between two states.
enum class TimeScale {
  kLogarithmic,  ///< linear in ln(1 + t/tau)
  kLinear        ///< linear in t
};

/// An interpolation between measured states.
struct Interpolation {
  TimeScale scale = TimeScale::kLogarithmic;  ///< how the running time enters
  double time_constant = kHour;               ///< tau of kLogarithmic [s]
};

/// What the heights of all measured faces count from.
enum class Datum {
  kOwn,    ///< each from its own: they are known up to an offset and a tilt
  kCommon  ///< one datum on the ring, as given: material only disappears between them
};

/// A ring that was measured after a running time.
struct MeasuredState {
  double time = 0;    ///< running time [s]
  cycle::Case input;  ///< whose face, N, beta, sigma and zeta are those of the state
  SourceMark mark;    ///< place in the file of its running time
};

/// A running time that is reported.
struct ReportedTime {
  double time = 0;  ///< running time [s]
  SourceMark mark;  ///< place in the file
};

/// Speed, gas and oil at which the ring runs for a share of the time.
struct OperatingPoint {
  std::string name;   ///< as results call it
  double share = 1;   ///< share of the running time; 0: reported, not part of the duty [-]
  cycle::Case input;  ///< with the ring of the base case
};

/// Where roughness and shear strength of a ring come from whose face wears.
enum class WornSurface {
  kFrozen,  ///< those of the base case
  kPath     ///< those of the path between the measured states
};

/// How wear is integrated over the running time.
enum class WearScheme {
  kHeun,  ///< mean of the wear rates at both ends of a jump
  kEuler  ///< that at its start
};

/// Which edge of a face that wears may have been the chamber edge; each is a scenario of its own.
enum class WornOrientations {
  kGiven,  ///< as the case states it
  kBoth    ///< that and the ring turned over, at twice the cost
};

/// Where a wear coefficient comes from.
enum class CoefficientSource {
  kStated,  ///< given
  kFitted   ///< to the measured states: a range
};

/// Archard wear of the face.
struct Wear {
  CoefficientSource source = CoefficientSource::kStated;  ///< given or fitted
  double coefficient = 0;                                 ///< k: depth per pressure and sliding length [m2/N]
  std::optional<double> running_in_coefficient;           ///< k_0, until running_in_time; absent: k all the time [m2/N]
  double running_in_time = 10 * kHour;                    ///< [s]
  WornSurface surface = WornSurface::kFrozen;             ///< roughness and shear strength
  WornOrientations orientations = WornOrientations::kGiven;  ///< chamber edge of the face
  WearScheme scheme = WearScheme::kHeun;                     ///< integration over the running time
  std::optional<int> jumps;        ///< equal ones over the time to the last reported one; absent: as the two below ask
  double largest_depth = 0.15e-6;  ///< largest depth worn in a jump [m]
  double jump_error = 0.02e-6;     ///< by which the two stages of a jump may differ [m]; Heun
  double tilt_spread = 0;          ///< a: the ring is tilted by -a to a, all alike often [rad]
  int tilt_samples = 12;           ///< tilts that stand for the spread
  double edge_factor = 1;          ///< factor of the coefficient in the edge zones [-]
  double edge_distance = 0.3e-3;   ///< from the middle of the face to the edge zones [m]
  std::optional<double> liner_coefficient;  ///< k of the liner along the stroke; absent: it does not wear [m2/N]
  std::optional<double> coating_thickness;  ///< at whose depth it ends; absent: not known [m]
  SourceMark mark = {};                     ///< place of the table in the file
};

/// The surface whose wear smooths the pair.
enum class RunningInSurface {
  kLiner,  ///< as deep as it is worn along the stroke
  kRing    ///< as deep as the face is worn
};

/// A roughness that falls with the worn depth, eq-life-run-in.
struct RunningIn {
  double roughness_limit = 0;  ///< towards which it falls: of Rpq of a plateau, else of contact.roughness [m]
  double depth_scale = 0;      ///< worn depth over which its excess falls to 1/e of itself [m]
  RunningInSurface surface = RunningInSurface::kLiner;  ///< surface whose depth counts
  SourceMark mark = {};                                 ///< place of the table in the file
  SourceMark limit_mark = {};                           ///< place of the limit
  SourceMark scale_mark = {};                           ///< place of the depth scale
};

/// Gas pressures next to and behind a ring whose pack is given.
enum class RingPressures {
  kGiven,    ///< those of the cases
  kComputed  ///< those of the gas of the pack, with the end gap as worn
};

/// The pack that the ring belongs to: its blow-by grows with the worn end gap.
struct RingPack {
  cycle::Case input;     ///< a pack or a single ring whose gas path is computed; speed and gas are those of the points
  std::size_t ring = 1;  ///< which of its rings wears, from the chamber
  RingPressures pressures = RingPressures::kGiven;  ///< gas pressures of the ring
  SourceMark mark;                                  ///< place of its case in the file
};

/// A limit that ends a life as its user states it; from whichever side its value starts.
struct EndRule {
  std::string quantity;  ///< one of limitable_quantities()
  double limit = 0;      ///< [SI]
};

/// What a life is computed from.
struct Life {
  std::string title;                    ///< as pages show it
  Mode mode = Mode::kMeasuredPath;      ///< path or scenario
  std::vector<ReportedTime> times;      ///< increasing
  std::vector<MeasuredState> states;    ///< anchors of the path, in the order of their running times
  Interpolation path;                   ///< between them
  Datum datum = Datum::kOwn;            ///< datum of the faces of these states
  std::vector<EndRule> end_rules;       ///< when the life ends; empty: no rule
  Wear wear;                            ///< wear of Mode::kArchard
  std::optional<RunningIn> running_in;  ///< absent: the roughness is as `wear.surface` has it
  std::optional<RingPack> pack;         ///< absent: gas pressures as the cases have them, blow-by not known
  /// Operating points of the duty, with shares of 1 in all, then those only reported.
  std::vector<OperatingPoint> points;
  /// With what its cycles are computed where cases ask for an accuracy, as sentences.
  std::string accuracy;
};

std::size_t n_duty_points(const Life& life);  ///< those first points with a share of the time

/// All that is wrong with a life beyond the faults of its cases, each at its place.
std::vector<Fault> faults_of(const Life& life);

}  // namespace ringfilm::life
