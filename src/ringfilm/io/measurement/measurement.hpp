#pragma once
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

/// What the commands that read instruments hand over: the same document is printed, written as JSON and NetCDF, and
/// drawn as a page. All numbers are SI; a value that is not known is NaN.
namespace ringfilm::io {

/// A number with its name and unit.
struct MeasuredValue {
  std::string name;          ///< name of the JSON key and NetCDF variable, e.g. "asperity_density"
  std::string long_name;     ///< "density of asperity peaks"
  std::string symbol;        ///< "N"
  std::string unit;          ///< SI, UDUNITS spelling; "1" dimensionless
  std::string display_unit;  ///< engineer's unit
  double value = std::numeric_limits<double>::quiet_NaN();
  double standard_error = std::numeric_limits<double>::quiet_NaN();
  std::string remark;  ///< which filter, pixel size and rule it holds for
};

/// Values that form a table.
struct MeasuredGroup {
  std::string title;
  std::vector<MeasuredValue> values;
};

struct MeasuredAxis {
  std::string name;
  std::string long_name;
  std::string unit;
  std::string display_unit;
  bool logarithmic = false;
};

/// Numbers over a common axis, drawn as lines or points.
struct MeasuredSeries {
  std::string name;
  std::string label;  ///< empty: in files, not drawn
  std::vector<double> y;
  bool points = false;  ///< drawn as points, not as a line
};

struct MeasuredMark {
  double x = 0;
  std::string label;
};

struct MeasuredCurve {
  std::string name;
  std::string title;
  std::string caption;
  MeasuredAxis x_axis, y_axis;
  std::vector<double> x;               ///< never turns back where lines are drawn
  std::vector<MeasuredSeries> series;  ///< each as long as x; NaN: no point
  std::vector<MeasuredMark> marks;     ///< upright lines, for example the cut-off that was used
};

/// A rectangle of a map that is distinguished, for example a region of interest.
struct MeasuredFrame {
  double x = 0, y = 0, width = 0, height = 0;  ///< [m]
  std::string label;
};

/// Heights or another quantity on an even grid; row after row, the first row at y = 0, NaN where there is none.
struct MeasuredMap {
  std::string name;
  std::string title;
  std::string caption;
  std::size_t points_x = 0, points_y = 0;
  double step_x = 0, step_y = 0;  ///< [m]
  std::string long_name, unit, display_unit;
  std::vector<double> values;
  std::vector<MeasuredFrame> frames;
};

/// A numbered table of rows, for example parameters against the cut-off or of each region: columns of equal length.
struct MeasuredTable {
  std::string name;
  std::string title;
  std::vector<MeasuredValue> columns;       ///< name, unit and so on; their `value` is not used
  std::vector<std::vector<double>> values;  ///< one list of rows for each column
  std::vector<std::string> row_labels;      ///< empty, or one for each row
};

struct Measurement {
  std::string kind;                     ///< "surface", "pair", "contact", "friction-band", "conformity", "face",
                                        ///< "lateral-force"
  std::string title;                    ///< title of the page
  std::vector<std::string> sources;     ///< file, format, channel, plausibility: a line each
  std::vector<std::string> statements;  ///< what was done, in its order: form, filters, rules
  std::vector<std::string> notes;       ///< what the reader should consider before using the numbers
  std::vector<std::string> key_values;  ///< names of the values that come first on the page; empty: the first three
  std::vector<MeasuredGroup> groups;
  std::vector<MeasuredTable> tables;
  std::vector<MeasuredMap> maps;
  std::vector<MeasuredCurve> curves;
  std::string fragment;  ///< TOML that a case includes; empty if none
};

/// Throws std::logic_error where the document itself is wrong: a name that is not a word (a letter, then letters,
/// digits and "_") or is repeated, lists of unequal length, a line over places that turn back, a key value that is not
/// there.
void check_measurement(const Measurement& measurement);

}  // namespace ringfilm::io
