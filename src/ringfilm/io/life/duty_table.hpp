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
  const ReadBase& read_base;
  const std::string& folder;  ///< of the life's file, from which its file names count
  const Units& units;
};

/// A duty as its table states it.
struct Duty {
  std::vector<life::OperatingPoint> points;  ///< shares of 1 in all; empty where it was refused
  std::optional<double> length;              ///< of all repetitions [s]; nothing: as long as the life
};

/// The table [duty]: segments with durations, or points with weights. What is wrong goes to `faults`.
Duty read_duty_table(const TomlValue& value, const DutySources& sources, std::vector<Fault>& faults);

/// The tables [[report_point]]: operating points outside the duty, with a share of 0, after those of `points`.
void read_report_points(const std::vector<TomlValue>& values, const DutySources& sources,
                        std::vector<life::OperatingPoint>& points, std::vector<Fault>& faults);

}  // namespace ringfilm::io
