#include "ringfilm/io/measurement/measurement_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "ringfilm/io/measurement/thinned_curve.hpp"

namespace ringfilm::io {
namespace {

using nlohmann::ordered_json;

/// A long profile has millions of points: the NetCDF file contains them.
constexpr std::size_t kMaxPointsOfACurve = 20000;

/// The sign of a zero has no meaning, and JSON has no NaN.
ordered_json exact(double value) { return std::isfinite(value) ? ordered_json(value + 0.0) : ordered_json(nullptr); }

ordered_json list(const std::vector<double>& values) {
  ordered_json array = ordered_json::array();
  for (const double value : values) array.push_back(exact(value));
  return array;
}

/// A count is written as one.
ordered_json number(double value) {
  constexpr double kExactWholeNumbers = 9007199254740992.0;  // 2^53
  if (std::abs(value) < kExactWholeNumbers && value == std::floor(value)) return static_cast<long long>(value);
  return exact(value);
}

ordered_json values_object(const std::vector<MeasuredGroup>& groups) {
  ordered_json object = ordered_json::object();
  for (const MeasuredGroup& group : groups) {
    for (const MeasuredValue& value : group.values) {
      object[value.name] = {{"value", exact(value.value)},
                            {"unit", value.unit},
                            {"standard_error", exact(value.standard_error)},
                            {"remark", value.remark},
                            {"long_name", value.long_name},
                            {"symbol", value.symbol},
                            {"group", group.title}};
    }
  }
  return object;
}

ordered_json table_object(const MeasuredTable& table) {
  ordered_json columns = ordered_json::object();
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const MeasuredValue& column = table.columns[i];
    columns[column.name] = {{"unit", column.unit},
                            {"long_name", column.long_name},
                            {"symbol", column.symbol},
                            {"remark", column.remark},
                            {"values", list(table.values[i])}};
  }
  return {{"title", table.title}, {"row_labels", table.row_labels}, {"columns", columns}};
}

ordered_json curve_object(const MeasuredCurve& whole) {
  const std::optional<MeasuredCurve> few = thinned(whole, kMaxPointsOfACurve);
  const MeasuredCurve& curve = few ? *few : whole;
  ordered_json series = ordered_json::object(), marks = ordered_json::array();
  for (const MeasuredSeries& one : curve.series) {
    series[one.name] = {{"label", one.label}, {"unit", curve.y_axis.unit}, {"values", list(one.y)}};
  }
  for (const MeasuredMark& mark : curve.marks) marks.push_back({{"x", exact(mark.x)}, {"label", mark.label}});
  ordered_json object = {{"title", curve.title},
                         {"x",
                          {{"name", curve.x_axis.name},
                           {"long_name", curve.x_axis.long_name},
                           {"unit", curve.x_axis.unit},
                           {"values", list(curve.x)}}},
                         {"series", series},
                         {"marks", marks}};
  if (few) object["thinned_from"] = whole.x.size();
  return object;
}

ordered_json map_object(const MeasuredMap& map) {
  ordered_json frames = ordered_json::array();
  for (const MeasuredFrame& frame : map.frames) {
    frames.push_back({{"label", frame.label},
                      {"x", exact(frame.x)},
                      {"y", exact(frame.y)},
                      {"width", exact(frame.width)},
                      {"height", exact(frame.height)}});
  }
  return {{"title", map.title},   {"points_x", map.points_x}, {"points_y", map.points_y}, {"step_x", map.step_x},
          {"step_y", map.step_y}, {"unit", map.unit},         {"frames", frames}};
}

template <class Parts, class ToObject>
ordered_json by_name(const Parts& parts, ToObject to_object) {
  ordered_json object = ordered_json::object();
  for (const auto& part : parts) object[part.name] = to_object(part);
  return object;
}

}  // namespace

std::string measurement_json(const Measurement& measurement, const NamedNumbers& numbers, const Provenance& provenance,
                             const NamedLists& lists, const NamedRows& rows, const NamedObjects& objects) {
  check_measurement(measurement);
  ordered_json object = {{"kind", measurement.kind}, {"title", measurement.title}};
  const ordered_json parts = {{"values", values_object(measurement.groups)},
                              {"tables", by_name(measurement.tables, table_object)},
                              {"curves", by_name(measurement.curves, curve_object)},
                              {"maps", by_name(measurement.maps, map_object)},
                              {"sources", measurement.sources},
                              {"statements", measurement.statements},
                              {"notes", measurement.notes},
                              {"fragment", measurement.fragment},
                              {"program", provenance.program},
                              {"commit", provenance.commit}};
  const auto put = [&](const std::string& name, ordered_json value) {
    if (object.contains(name) || parts.contains(name)) throw std::logic_error("a measurement: two are called " + name);
    object[name] = std::move(value);
  };
  for (const auto& [name, value] : numbers) put(name, number(value));
  for (const auto& [name, values] : lists) put(name, list(values));
  for (const auto& [name, all] : rows) {
    ordered_json array = ordered_json::array();
    for (const std::vector<double>& row : all) array.push_back(list(row));
    put(name, std::move(array));
  }
  for (const auto& [name, members] : objects) {
    ordered_json one = ordered_json::object();
    for (const auto& [key, values] : members) one[key] = values.size() == 1 ? exact(values.front()) : list(values);
    put(name, std::move(one));
  }
  object.update(parts);
  // A file name in another encoding than UTF-8 must not lose the result.
  return object.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace ringfilm::io
