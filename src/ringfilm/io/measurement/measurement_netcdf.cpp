#include "ringfilm/io/measurement/measurement_netcdf.hpp"

#include <cmath>
#include <set>
#include <stdexcept>

#include "ringfilm/io/result/provenance_attributes.hpp"
#include "ringfilm/io/result/result_file_quantities.hpp"
#include "ringfilm/io/result/result_file_writer.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"

namespace ringfilm::io {
namespace {

constexpr long kMeasurementSchema = 1;

/// The parts of the document as variables; a curve, table or map gives its name to all that belongs to it.
class Layout {
 public:
  explicit Layout(ResultFileWriter& file) : file_(file) {}

  void value(const MeasuredValue& value, const std::string& group) {
    file_.scalar(taken(variable(value.name, value)), value.value);
    if (std::isfinite(value.standard_error)) file_.describe(value.name, "standard_error", value.standard_error);
    remark(value.name, value.remark);
    file_.describe(value.name, "group", group);
  }

  void table(const MeasuredTable& table) {
    const std::string rows = table.name + "_row";
    if (!table.row_labels.empty()) {
      file_.texts(rows.c_str(), taken(text(rows, "label of each row of " + table.title)), table.row_labels);
    }
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      const std::string name = table.name + "_" + table.columns[i].name;
      file_.numbers({rows.c_str()}, taken(variable(name, table.columns[i])), table.values[i]);
      remark(name, table.columns[i].remark);
    }
  }

  void curve(const MeasuredCurve& curve) {
    const std::string along = curve.name + "_" + curve.x_axis.name, marks = curve.name + "_mark";
    file_.numbers({along.c_str()}, taken(described(along, curve.x_axis.unit, curve.x_axis.long_name)), curve.x);
    for (const MeasuredSeries& series : curve.series) {
      const std::string name = curve.name + "_" + series.name;
      const std::string& quantity = curve.y_axis.long_name;
      const bool is_obvious = series.label.empty() || series.label == quantity;
      file_.numbers({along.c_str()},
                    taken(described(name, curve.y_axis.unit, is_obvious ? quantity : quantity + ", " + series.label)),
                    series.y);
      file_.describe(name, "title", curve.title);
    }
    std::vector<double> places;
    std::vector<std::string> labels;
    for (const MeasuredMark& mark : curve.marks) {
      places.push_back(mark.x);
      labels.push_back(mark.label);
    }
    if (places.empty()) return;
    file_.numbers({marks.c_str()}, taken(described(marks + "_place", curve.x_axis.unit, "places distinguished")),
                  places);
    file_.texts(marks.c_str(), taken(text(marks + "_label", "text at each such place")), labels);
  }

  void map(const MeasuredMap& map) {
    const std::string x = map.name + "_x", y = map.name + "_y";
    file_.numbers({x.c_str()}, taken(described(x, "m", "place along a row", "x")), places(map.points_x, map.step_x));
    file_.numbers({y.c_str()}, taken(described(y, "m", "place of the row", "y")), places(map.points_y, map.step_y));
    file_.numbers({y.c_str(), x.c_str()}, taken(described(map.name, map.unit, map.long_name)), map.values);
    file_.describe(map.name, "title", map.title);
    if (!map.frames.empty()) frames(map);
  }

  void texts(const char* name, const char* long_name, const std::vector<std::string>& lines) {
    // Not called as the dimension: long texts are not labels.
    if (!lines.empty()) file_.texts(name, taken(text(name + std::string("_text"), long_name)), lines);
  }

 private:
  static cycle::Quantity variable(const std::string& name, const MeasuredValue& value) {
    return {name, value.unit, value.display_unit, value.long_name, value.symbol, ""};
  }

  /// Two of one name would be reported by the library only, as a file that cannot be written.
  const cycle::Quantity& taken(const cycle::Quantity& quantity) {
    if (!names_.insert(quantity.name).second) {
      throw std::logic_error("a measurement: two variables are called " + quantity.name);
    }
    return quantity;
  }

  static std::vector<double> places(std::size_t points, double step) {
    std::vector<double> places;
    for (std::size_t i = 0; i < points; ++i) places.push_back(static_cast<double>(i) * step);
    return places;
  }

  void remark(const std::string& variable, const std::string& text) {
    if (!text.empty()) file_.describe(variable, "remark", text);
  }

  void frames(const MeasuredMap& map) {
    const std::string frame = map.name + "_frame";
    std::vector<std::string> labels;
    for (const MeasuredFrame& one : map.frames) labels.push_back(one.label);
    file_.texts(frame.c_str(), taken(text(frame, "label of each region")), labels);
    const auto column = [&](const char* name, const char* long_name, double MeasuredFrame::*member) {
      std::vector<double> values;
      for (const MeasuredFrame& one : map.frames) values.push_back(one.*member);
      file_.numbers({frame.c_str()}, taken(described(frame + name, "m", long_name)), values);
    };
    column("_x", "left edge of the region", &MeasuredFrame::x);
    column("_y", "first row of the region", &MeasuredFrame::y);
    column("_width", "width of the region", &MeasuredFrame::width);
    column("_height", "height of the region", &MeasuredFrame::height);
  }

  ResultFileWriter& file_;
  std::set<std::string> names_;
};

}  // namespace

void write_measurement(const std::string& path, const Measurement& measurement, const Provenance& provenance) {
  check_measurement(measurement);
  ResultFileWriter file(path);
  file.attribute("Conventions", std::string("CF-1.10"));
  file.attribute("ringfilm_measurement_schema", kMeasurementSchema);
  file.attribute("kind", measurement.kind);
  file.attribute("title", measurement.title);
  exchange_provenance(file, provenance);
  Layout layout(file);
  layout.texts("source", "what was read", measurement.sources);
  layout.texts("statement", "what was done, in its order", measurement.statements);
  layout.texts("note", "what to consider before using the numbers", measurement.notes);
  for (const MeasuredGroup& group : measurement.groups) {
    for (const MeasuredValue& value : group.values) layout.value(value, group.title);
  }
  for (const MeasuredTable& table : measurement.tables) layout.table(table);
  for (const MeasuredCurve& curve : measurement.curves) layout.curve(curve);
  for (const MeasuredMap& map : measurement.maps) layout.map(map);
  if (!measurement.fragment.empty()) {
    file.scalar(text("fragment", "TOML that a case includes"), measurement.fragment);
  }
  write_atomically(path, file.bytes());
}

}  // namespace ringfilm::io
