#include "ringfilm/io/measurement/measurement.hpp"

#include <algorithm>
#include <functional>
#include <set>
#include <stdexcept>

namespace ringfilm::io {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

[[noreturn]] void fail(const std::string& what) { throw std::logic_error("a measurement: " + what); }

/// Names that must differ, and be words that any program takes.
class Names {
 public:
  explicit Names(std::string where) : where_(std::move(where)) {}
  void add(const std::string& name) {
    const bool is_word = !name.empty() && is_letter(name.front()) && std::all_of(name.begin(), name.end(), [](char c) {
      return is_letter(c) || is_digit(c) || c == '_';
    });
    if (!is_word) fail(where_ + ": \"" + name + "\" is not a name");
    if (!known_.insert(name).second) fail(where_ + ": two are called " + name);
  }
  bool has(const std::string& name) const { return known_.count(name) > 0; }

 private:
  std::string where_;
  std::set<std::string> known_;
};

bool turns_back(const std::vector<double>& x) {
  // A NaN is not an order either.
  const auto disordered = [&](auto before) {
    return std::adjacent_find(x.begin(), x.end(), [&](double a, double b) { return !before(a, b); }) != x.end();
  };
  return disordered(std::less_equal<>()) && disordered(std::greater_equal<>());
}

void check_curve(const MeasuredCurve& curve) {
  Names series("series of " + curve.name);
  series.add(curve.x_axis.name);
  bool has_line = false;
  for (const MeasuredSeries& one : curve.series) {
    series.add(one.name);
    has_line = has_line || !one.points;
    if (one.y.size() != curve.x.size()) fail(curve.name + ": " + one.name + " is not as long as x");
  }
  if (has_line && turns_back(curve.x)) fail(curve.name + ": a line over places that turn back");
}

void check_table(const MeasuredTable& table) {
  Names columns("columns of " + table.name);
  for (const MeasuredValue& column : table.columns) columns.add(column.name);
  if (table.columns.size() != table.values.size()) fail(table.name + ": columns without values");
  for (const std::vector<double>& rows : table.values) {
    if (rows.size() != table.values.front().size()) fail(table.name + ": columns of unequal length");
  }
  if (!table.row_labels.empty() && !table.values.empty() && table.row_labels.size() != table.values.front().size()) {
    fail(table.name + ": not one label for each row");
  }
}

void check_map(const MeasuredMap& map) {
  if (map.points_x == 0 || map.points_y == 0 || map.values.size() / map.points_x != map.points_y ||
      map.values.size() % map.points_x != 0) {
    fail(map.name + ": not as many values as points");
  }
  if (!(map.step_x > 0) || !(map.step_y > 0)) fail(map.name + ": a step that is not a length");
}

}  // namespace

void check_measurement(const Measurement& measurement) {
  Names values("values"), tables("tables"), curves("curves"), maps("maps");
  for (const MeasuredGroup& group : measurement.groups) {
    for (const MeasuredValue& value : group.values) values.add(value.name);
  }
  for (const std::string& name : measurement.key_values) {
    if (!values.has(name)) fail("no value is called " + name);
  }
  for (const MeasuredTable& table : measurement.tables) tables.add(table.name), check_table(table);
  for (const MeasuredCurve& curve : measurement.curves) curves.add(curve.name), check_curve(curve);
  for (const MeasuredMap& map : measurement.maps) maps.add(map.name), check_map(map);
}

}  // namespace ringfilm::io
