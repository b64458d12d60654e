#pragma once
#include <string>
#include <vector>

#include "ringfilm/base/error.hpp"
#include "ringfilm/cycle/case/case.hpp"

/// The life of a ring: measured states at their running hours, and what friction, oil and film are over hours
/// (docs/theory/life.md). One plain value in SI; its defaults are written here.
namespace ringfilm::life {

inline constexpr double kHour = 3600;  ///< [s]

std::string hours_text(double time);  ///< a running time [s] as messages show it: "10 h"

/// Where face, roughness and shear strength come from over the running time.
enum class Mode {
  kMeasuredPath,  ///< interpolated between measured states
};

/// How the running time enters an interpolation between two states.
enum class TimeScale {
  kLogarithmic,  ///< linear in ln(1 + t/tau)
  kLinear        ///< linear in t
};

/// An interpolation between measured states.
struct Interpolation {
  TimeScale scale = TimeScale::kLogarithmic;
  double time_constant = kHour;  ///< tau of kLogarithmic [s]
};

/// A ring that was measured after a running time.
struct MeasuredState {
  double time = 0;    ///< running time [s]
  cycle::Case input;  ///< whose face, N, beta, sigma and zeta are those of the state
  SourceMark mark;    ///< of its running time
};

/// A running time that is reported.
struct ReportedTime {
  double time = 0;  ///< [s]
  SourceMark mark;
};

/// Speed, gas and oil at which the ring runs for a share of the time.
struct OperatingPoint {
  std::string name;
  double share = 1;   ///< of the running time [-]
  cycle::Case input;  ///< with the ring of the base case
};

/// What a life is computed from.
struct Life {
  std::string title;
  Mode mode = Mode::kMeasuredPath;
  std::vector<ReportedTime> times;     ///< increasing
  std::vector<MeasuredState> states;   ///< anchors of the path, in the order of their running times
  Interpolation path;                  ///< between them
  std::vector<OperatingPoint> points;  ///< at least one; the shares are 1 in all
};

/// All that is wrong with a life beyond the faults of its cases, each at its place.
std::vector<Fault> faults_of(const Life& life);

}  // namespace ringfilm::life
