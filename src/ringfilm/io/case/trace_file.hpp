#pragma once
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/base/error.hpp"
#include "ringfilm/cycle/case/case.hpp"
#include "ringfilm/io/text/source_text.hpp"
#include "ringfilm/io/text/units.hpp"

namespace ringfilm::io {

/// Where a trace was measured: the peak of a crankcase may be low, and anywhere.
enum class TracePlace { kCylinder, kCrankcase };

/// What the case states about the columns of a trace; nothing where only the file states it.
struct TraceColumns {
  std::optional<std::string> pressure_column, angle_column;
  std::optional<std::string> pressure_unit, angle_unit;  ///< for a header without units
  cycle::PressureReference reference{};
  TracePlace place = TracePlace::kCylinder;
};

/// A trace in SI and degrees; pressures absolute or gauge, angles with their own zero, both as the file has them.
struct TraceFile {
  cycle::SampledTrace samples;
  std::string sha256;
  std::vector<std::string> notes;
};

/// A column, unit or pressure reference that the case states, or leaves to the file, does not fit the trace. Where two
/// keys have to change together, it is right to refuse each alone.
class TraceKeyError : public InputError {
 public:
  using InputError::InputError;
};

/// A column of a trace as its header shows it.
struct TraceColumn {
  std::string name;
  std::optional<std::string> unit;  ///< as written
};

/// What a trace shows of itself before a case states anything of it.
struct TraceOutline {
  std::vector<TraceColumn> angle, pressure;  ///< the columns that may be the crank angle and the pressure
  bool has_gauge_unit = false;               ///< is the unit of the one pressure a gauge one, such as barg?
  cycle::SampledTrace samples;               ///< in SI and degrees; empty unless one column with its unit is either
};

/// Looks at the header of a trace. Throws InputError for a file that is not a table of numbers.
TraceOutline trace_outline(const NamedFile& file, const Units& units);

/// Reads pressure [Pa] against crank angle [degree] from a CSV file. Throws InputError with all faults of the file:
/// those of read_csv, columns that cannot be distinguished, units missing, contradictory or of the wrong kind, angles
/// that do not increase, leave a hole or span over 720 degrees, pressures that cannot be absolute (or gauge) or do not
/// repeat after a cycle; TraceKeyError where another column, unit or reference may be right.
TraceFile read_trace(const NamedFile& file, const TraceColumns& stated, const Units& units);

}  // namespace ringfilm::io
