#include "ringfilm/io/verification/overlay_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/cycle/setup/kinematics.hpp"
#include "ringfilm/io/table/csv_quantity.hpp"
#include "ringfilm/io/text/suggestion.hpp"

namespace ringfilm::io {
namespace {

constexpr const char* kAngle = "crank_angle";

const cycle::CurveQuantity* find_curve(const std::string& name) {
  const auto& quantities = cycle::curve_quantities();
  const auto found = std::find_if(quantities.begin(), quantities.end(), [&](const auto& q) { return q.name == name; });
  return found == quantities.end() ? nullptr : &*found;
}

Fault unknown_curve(const CsvFile& csv, std::size_t i_column) {
  std::vector<std::string> names;
  for (const auto& quantity : cycle::curve_quantities()) names.push_back(quantity.name);
  const std::string& written = csv.columns[i_column].name;
  const std::string nearest = nearest_word(written, names);
  return {csv.header_mark(i_column), "no curve of a result is called " + written,
          nearest.empty() ? "a column such as friction_on_liner [N] or min_film_thickness [um] is required here"
                          : "did you mean " + nearest + "?"};
}

void check_angles(const CsvFile& csv, const std::vector<double>& angle, std::vector<Fault>& faults) {
  const std::size_t i_column = *csv.find(kAngle);
  if (const auto fault = crank_angle_fault(angle, [&](std::size_t row) { return csv.cell_mark(row, i_column); }))
    faults.push_back(*fault);
  // One cycle may be counted from -360, from 0 or from -720 degrees; what lies further off is not a crank angle.
  constexpr double kFurthestDeg = cycle::kCycleDeg;
  const auto far = std::find_if(angle.begin(), angle.end(), [](double a) { return std::abs(a) > kFurthestDeg; });
  if (far == angle.end()) return;
  faults.push_back({csv.cell_mark(static_cast<std::size_t>(far - angle.begin()), i_column),
                    fmt::format("the crank angle {:.8g} degree is not within -720 and 720 degree", *far),
                    "count from firing TDC; is the unit of the column right?"});
}

}  // namespace

std::vector<OverlayCurve> read_overlay(const std::string& path, const Units& units) {
  const CsvFile csv = read_csv({path, path});
  std::vector<Fault> faults;
  const std::vector<double> angle = quantity_column(csv, kAngle, "degree", "crank_angle [degree]", units, faults);
  if (!angle.empty()) check_angles(csv, angle, faults);
  std::vector<OverlayCurve> curves;
  for (std::size_t i = 0; i < csv.columns.size(); ++i) {
    const CsvColumn& column = csv.columns[i];
    if (column.name == kAngle) continue;
    const cycle::CurveQuantity* quantity = find_curve(column.name);
    if (quantity == nullptr) {
      faults.push_back(unknown_curve(csv, i));
      continue;
    }
    const bool is_plain = quantity->unit == "1" && !column.unit;
    const std::string example = quantity->name + " [" + quantity->display_unit + "]";
    curves.push_back(
        {std::filesystem::path(path).stem().string(), quantity->name, path, angle,
         is_plain ? column.values : quantity_column(csv, column.name, quantity->unit, example, units, faults)});
  }
  if (curves.empty() && faults.empty()) {
    faults.push_back({csv.source.mark(csv.header_line, 1), "there is no column beside the crank angle",
                      "for example friction_on_liner [N]"});
  }
  if (!faults.empty()) throw InputError(std::move(faults));
  return curves;
}

}  // namespace ringfilm::io
