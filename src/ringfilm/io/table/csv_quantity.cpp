#include "ringfilm/io/table/csv_quantity.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "ringfilm/cycle/setup/kinematics.hpp"

namespace ringfilm::io {
std::vector<double> quantity_column(const CsvFile& csv, const std::string& name, const std::string& si_unit,
                                    const std::string& example, const Units& units, std::vector<Fault>& faults) {
  const auto i_column = csv.find(name);
  if (!i_column) {
    faults.push_back({csv.source.mark(csv.header_line, 1), "the file has no column " + name,
                      "a column " + example + " is required; it has: " + csv.names()});
    return {};
  }
  const CsvColumn& column = csv.columns[*i_column];
  for (std::size_t k = *i_column + 1; k < csv.columns.size(); ++k) {
    if (csv.columns[k].name != column.name || name != column.name) continue;
    faults.push_back({csv.header_mark(k), "the file has two columns " + name, "which one is meant? take one out"});
    return {};
  }
  const auto in_name =
      with_unit_of_name(column, [&](const std::string& text) { return units.measures(text, si_unit); });
  const std::optional<std::string>& unit = in_name ? in_name->unit : column.unit;
  if (!unit) {
    faults.push_back({csv.header_mark(*i_column), "the column " + name + " has no unit", "write it as " + example});
    return {};
  }
  try {
    const Scale scale = units.scale(*unit, si_unit);
    std::vector<double> si(column.values.size());
    std::transform(column.values.begin(), column.values.end(), si.begin(), [&](double v) { return scale.to_si(v); });
    return si;
  } catch (const UnitError& problem) {
    faults.push_back({csv.unit_mark(*i_column), "the column " + name + " " + problem.what(),
                      problem.remedy.empty() ? "for example " + example : problem.remedy});
    return {};
  }
}

std::optional<Fault> crank_angle_fault(const std::vector<double>& angle,
                                       const std::function<SourceMark(std::size_t)>& place) {
  for (std::size_t k = 1; k < angle.size(); ++k) {
    if (angle[k] > angle[k - 1]) continue;
    return Fault{place(k),
                 angle[k] == angle[k - 1]
                     ? fmt::format("the crank angle {:.8g} degree comes twice", angle[k])
                     : fmt::format("the crank angle falls from {:.8g} to {:.8g} degree", angle[k - 1], angle[k]),
                 "crank angles must increase from row to row"};
  }
  if (angle.back() - angle.front() <= cycle::kCycleDeg * (1 + 1e-9)) return std::nullopt;
  return Fault{place(angle.size() - 1),
               fmt::format("the crank angles span {:.8g} degree", angle.back() - angle.front()),
               "one cycle of 720 degree is expected; cut or average the cycles, or correct the unit of the angles"};
}

}  // namespace ringfilm::io
