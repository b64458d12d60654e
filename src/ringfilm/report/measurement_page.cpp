#include "ringfilm/report/measurement_page.hpp"

#include <algorithm>
#include <cmath>

#include "ringfilm/io/measurement/measurement_text.hpp"
#include "ringfilm/io/measurement/thinned_curve.hpp"
#include "ringfilm/report/html_text.hpp"
#include "ringfilm/report/page_template.hpp"
#include "ringfilm/report/payload/map_picture.hpp"
#include "ringfilm/report/payload/payload_numbers.hpp"
#include "ringfilm/report/payload/script_text.hpp"

namespace ringfilm::report {
namespace {

using nlohmann::ordered_json;

constexpr int kMeasuredDigits = 7;
/// So that the page stays below 2 MB: points of all pictures, of one side of one picture, of all curves.
constexpr double kPicturePoints = 2 * 512 * 512;
constexpr double kPictureSide = 512;
constexpr double kCurvePoints = 40000;
constexpr double kMinStretches = 150, kMaxStretches = 1000;

/// Numbers in the unit that people read: the page converts nothing.
class Shown {
 public:
  Shown(const std::string& unit, const std::string& display_unit, const io::Units& units)
      : unit_(display_unit.empty() ? unit : display_unit), scale_(io::display_scale(unit, display_unit, units)) {}

  const std::string& unit() const { return unit_; }
  double value(double si) const { return scale_.from_si(si); }
  double difference(double si) const { return scale_.from_si(si) - scale_.from_si(0); }
  std::vector<double> values(std::vector<double> si) const {
    for (double& value : si) value = scale_.from_si(value);
    return si;
  }

 private:
  std::string unit_;
  Scale scale_;
};

ordered_json value_object(const io::MeasuredValue& value, const io::Units& units) {
  const Shown shown(value.unit, value.display_unit, units);
  return {{"name", value.name},
          {"long_name", value.long_name},
          {"symbol", value.symbol},
          {"unit", shown.unit()},
          {"value", exact(shown.value(value.value))},
          {"error", exact(shown.difference(value.standard_error))},
          {"remark", value.remark}};
}

ordered_json table_object(const io::MeasuredTable& table, const io::Units& units) {
  ordered_json columns = ordered_json::array();
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const io::MeasuredValue& column = table.columns[i];
    const Shown shown(column.unit, column.display_unit, units);
    columns.push_back({{"name", column.name},
                       {"long_name", column.long_name},
                       {"symbol", column.symbol},
                       {"unit", shown.unit()},
                       {"remark", column.remark},
                       {"values", exact_list(shown.values(table.values[i]))}});
  }
  return {{"name", table.name}, {"title", table.title}, {"row_labels", table.row_labels}, {"columns", columns}};
}

ordered_json axis_object(const io::MeasuredAxis& axis, const io::Units& units) {
  return {{"long_name", axis.long_name},
          {"unit", Shown(axis.unit, axis.display_unit, units).unit()},
          {"logarithmic", axis.logarithmic}};
}

ordered_json curve_object(const io::MeasuredCurve& curve, std::size_t stretches, const io::Units& units) {
  const Shown across(curve.x_axis.unit, curve.x_axis.display_unit, units);
  const Shown up(curve.y_axis.unit, curve.y_axis.display_unit, units);
  ordered_json series = ordered_json::array(), marks = ordered_json::array();
  std::size_t n_drawn = 0;
  for (const io::MeasuredSeries& one : curve.series) {
    if (one.label.empty()) continue;
    const io::ThinnedSeries few = io::thinned(curve, one, stretches);
    n_drawn = std::max(n_drawn, few.x.size());
    series.push_back({{"label", one.label},
                      {"points", one.points},
                      {"x", rounded_list(across.values(few.x), kMeasuredDigits)},
                      {"y", rounded_list(up.values(few.y), kMeasuredDigits)}});
  }
  for (const io::MeasuredMark& mark : curve.marks) {
    marks.push_back({{"at", exact(across.value(mark.x))}, {"label", mark.label}});
  }
  return {{"name", curve.name},
          {"title", curve.title},
          {"caption", curve.caption},
          {"x", axis_object(curve.x_axis, units)},
          {"y", axis_object(curve.y_axis, units)},
          {"points", curve.x.size()},
          {"drawn", n_drawn},
          {"series", std::move(series)},
          {"marks", std::move(marks)}};
}

ordered_json point_object(const MapPoint& point, const Shown& shown) {
  return {{"x", point.x}, {"y", point.y}, {"value", exact(shown.value(point.value))}};
}

/// Places stay in metres: the page chooses their unit by the size of the map.
ordered_json map_object(const io::MeasuredMap& map, std::size_t most_points, const io::Units& units) {
  const Shown shown(map.unit, map.display_unit, units);
  const MapPicture picture = map_picture(map, most_points);
  ordered_json frames = ordered_json::array();
  for (const io::MeasuredFrame& frame : map.frames) {
    frames.push_back({{"x", exact(frame.x)},
                      {"y", exact(frame.y)},
                      {"width", exact(frame.width)},
                      {"height", exact(frame.height)},
                      {"label", frame.label}});
  }
  ordered_json object = {{"name", map.name},         {"title", map.title},
                         {"caption", map.caption},   {"long_name", map.long_name},
                         {"unit", shown.unit()},     {"points_x", map.points_x},
                         {"points_y", map.points_y}, {"step_x", map.step_x},
                         {"step_y", map.step_y},     {"missing_points", picture.missing_points},
                         {"empty", picture.empty()}, {"frames", std::move(frames)}};
  if (picture.empty()) return object;
  object.update({{"columns", picture.columns},
                 {"rows", picture.rows},
                 {"block_x", picture.block_x},
                 {"block_y", picture.block_y},
                 {"low", shown.value(picture.low)},
                 {"high", shown.value(picture.high)},
                 {"colour_low", shown.value(picture.colour_low)},
                 {"colour_high", shown.value(picture.colour_high)},
                 {"highest", point_object(picture.highest, shown)},
                 {"lowest", point_object(picture.lowest, shown)},
                 {"data", packed(picture.values)}});
  return object;
}

ordered_json groups_array(const io::Measurement& measurement, const io::Units& units) {
  ordered_json groups = ordered_json::array();
  for (const io::MeasuredGroup& group : measurement.groups) {
    ordered_json values = ordered_json::array();
    for (const io::MeasuredValue& value : group.values) values.push_back(value_object(value, units));
    groups.push_back({{"title", group.title}, {"values", std::move(values)}});
  }
  return groups;
}

ordered_json payload(const io::Measurement& measurement, const io::Units& units, const io::Provenance& provenance) {
  ordered_json tables = ordered_json::array(), maps = ordered_json::array(), curves = ordered_json::array();
  for (const io::MeasuredTable& table : measurement.tables) tables.push_back(table_object(table, units));
  const double n_maps = std::max<double>(1, static_cast<double>(measurement.maps.size()));
  const auto side = static_cast<std::size_t>(std::min(kPictureSide, std::sqrt(kPicturePoints / n_maps)));
  for (const io::MeasuredMap& map : measurement.maps) maps.push_back(map_object(map, side, units));
  std::size_t n_series = 0;
  for (const io::MeasuredCurve& curve : measurement.curves) n_series += curve.series.size();
  const double share = kCurvePoints / std::max<double>(1, static_cast<double>(n_series)) / 4;
  const auto stretches = static_cast<std::size_t>(std::clamp(share, kMinStretches, kMaxStretches));
  for (const io::MeasuredCurve& curve : measurement.curves) curves.push_back(curve_object(curve, stretches, units));
  return {{"kind", measurement.kind},
          {"title", measurement.title},
          {"sources", measurement.sources},
          {"statements", measurement.statements},
          {"notes", measurement.notes},
          {"key_values", measurement.key_values},
          {"groups", groups_array(measurement, units)},
          {"tables", std::move(tables)},
          {"maps", std::move(maps)},
          {"curves", std::move(curves)},
          {"fragment", measurement.fragment},
          {"provenance",
           {{"program", provenance.program}, {"commit", provenance.commit}, {"compiler", provenance.compiler}}}};
}

}  // namespace

std::string measurement_page(const io::Measurement& measurement, const io::Units& units,
                             const io::Provenance& provenance) {
  io::check_measurement(measurement);
  const page_template::PageTemplate parts = page_template::measurement();
  std::string page(parts.before_title);
  page += html_text(measurement.title);
  page += parts.before_data;
  // A file name in another encoding than UTF-8 is shown with a replacement sign, not refused.
  page +=
      script_text(payload(measurement, units, provenance).dump(-1, ' ', false, ordered_json::error_handler_t::replace));
  page += parts.after_data;
  return page;
}

}  // namespace ringfilm::report
