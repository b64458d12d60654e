#pragma once
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/base/error.hpp"
#include "ringfilm/case/case.hpp"
#include "ringfilm/io/table/text_table.hpp"
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
  std::optional<std::string>
      cycle{};  ///< which of several: "mean", "median" or its number; their mean where not stated
  TableReading table{};
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

/// The units that the columns of a trace have, in words.
inline constexpr const char *kAngleUnits = "degree or rad", *kPressureUnits = "bar, Pa, kPa or MPa";

/// What a trace shows of itself before a case states anything of it.
struct TraceOutline {
  std::vector<TraceColumn> angle, pressure;  ///< the columns that may be the crank angle and the pressure
  bool is_degree_by_span = false;            ///< has the angle no unit, and a span that is too long for radians?
  /// Reference that the unit of the one pressure states, bara or barg.
  std::optional<cycle::PressureReference> reference_of_unit;
  std::vector<double> crank_angle_deg;  ///< empty unless one column is the angle, in a unit that is known
  std::vector<double> pressure_values;  ///< empty where the angles are, or several columns may be the pressure
  bool is_in_pascal = false;            ///< the pressures; else as written, without unit
  std::vector<std::string> notes;       ///< how the text was read; what was omitted, turned or averaged

  /// Is one pressure alone not above zero, as a disturbed sample is? Many are in a gauge trace.
  bool has_lone_low_pressure() const;
};

/// The pattern "p*" of columns p1, p2, p3 that may have one cycle each; empty where their names
/// differ by more than a number that counts them.
std::string pattern_of_cycles(const std::vector<std::string>& names);

/// Looks at a trace. Throws InputError for a file that is not a table of numbers, and with the faults of read_trace
/// that hold whatever a case states.
TraceOutline trace_outline(const NamedFile& file, const Units& units, const TableReading& stated = {});

/// Reads pressure [Pa] against crank angle [degree] from a CSV file. Of several cycles, one after the other or in the
/// columns that a pattern names (p_*), one is made (trace_cycles.hpp); rows whose angle falls are turned about; up to
/// 1 % of rows without a number are omitted. Throws InputError with all faults of the file:
/// those of read_csv, columns that cannot be distinguished, units missing, contradictory or of the wrong kind, angles
/// that do not increase, leave a hole or span over 720 degrees, pressures that cannot be absolute (or gauge) or do not
/// repeat after a cycle; TraceKeyError where another column, unit or reference may be right.
TraceFile read_trace(const NamedFile& file, const TraceColumns& stated, const Units& units);

}  // namespace ringfilm::io
