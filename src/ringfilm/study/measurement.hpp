#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/case/case.hpp"
#include "ringfilm/cycle/result/result.hpp"

/// The numbers of one run by their names, whatever was run: what checks against known answers look up.
namespace ringfilm::study {

/// A run as numbers. A list is a value per instant; those that belong to the run as a whole have one entry.
struct Measurement {
  std::vector<double> instants;                       ///< times [s] of a pad, crank angles [degree] of a ring
  std::map<std::string, std::vector<double>> values;  ///< [SI]
  std::map<std::string, std::vector<double>> curves;  ///< curves of a ring over crank angle [SI]
};

/// Which number of a run.
struct Probe {
  /// One of measured_quantities(), or "<list>.1", ".2", ...: fronts from x = 0 on, regions of gas from the chamber on,
  /// events by crank angle.
  std::string quantity;
  std::optional<double> time;  ///< [s]; nothing: the last instant
};

/// Every quantity that a measurement of a pad or a ring can hold, lists of fronts without their number.
const std::vector<cycle::Quantity>& measured_quantities();

/// Is it a quantity of the gas between the rings, of a case read for the gas alone?
bool is_of_gas(const std::string& name);

/// The curve of a ring over crank angle of that name; nothing if there is none. A pad may have a number of that name.
std::optional<cycle::Quantity> find_curve(const std::string& name);

/// The quantity of a probe's name; nothing if there is none.
std::optional<cycle::Quantity> find_measured(const std::string& name);

/// Solves the case. Throws ConvergenceError where it has no solution.
Measurement measure(const cycle::Case& c);

/// The number that the probe names; NaN if the run has none there: a film that is full has no rupture, and a history
/// without an instant within half a step of the time asked for has no value then.
double value(const Measurement& measurement, const Probe& probe);

}  // namespace ringfilm::study
