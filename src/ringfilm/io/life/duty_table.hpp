#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/io/case/case_file.hpp"
#include "ringfilm/io/text/toml_tree.hpp"
#include "ringfilm/io/text/units.hpp"
#include "ringfilm/life/life.hpp"

namespace ringfilm::io {

/// Reads the base case of a life with overrides that a place of its file asks for; nothing where that is refused.
using ReadBase = std::function<std::optional<cycle::Case>(const std::vector<Override>&, const SourceMark&)>;

/// What the table [duty] is read with.
struct DutySources {
  const std::string& folder;  ///< folder of the life's file, to which its file names are relative
  const Units& units;
};

/// An operating point as the file states it, before its case is read.
struct StatedPoint {
  std::string name;
  double share = 0;  ///< share of the running time; 0: reported, not part of the duty [-]
  std::vector<Override> overrides;
  std::optional<double> peak;  ///< peak pressure to which the trace is scaled, with its reference [Pa]
  SourceMark mark, peak_mark;
};

/// A duty as its table states it.
struct Duty {
  std::vector<StatedPoint> points;  ///< points whose shares sum to 1; empty where the table was refused
  std::optional<double> length;     ///< length of all repetitions [s]; nothing: as long as the life
};

/// The table [duty]: segments with durations, or points with weights. What is wrong goes to `faults`.
Duty read_duty_table(const TomlValue& value, const DutySources& sources, std::vector<Fault>& faults);

/// The tables [[report_point]]: operating points outside the duty, with a share of 0. @param names_of_duty not theirs
std::vector<StatedPoint> read_report_points(const std::vector<TomlValue>& values,
                                            const std::vector<std::string>& names_of_duty, const DutySources& sources,
                                            std::vector<Fault>& faults);

/// With the case of each, which is read here; after ten that are refused the others are not.
std::vector<life::OperatingPoint> operating_points(const std::vector<StatedPoint>& stated, const ReadBase& read_base,
                                                   std::vector<Fault>& faults);

}  // namespace ringfilm::io
