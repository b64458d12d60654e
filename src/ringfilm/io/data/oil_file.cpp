#include "ringfilm/io/data/oil_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "ringfilm/cycle/setup/oil_setup.hpp"
#include "ringfilm/io/table/csv_quantity.hpp"

namespace ringfilm::io {
namespace {

std::vector<double> sorted_unique(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

std::size_t index_of(const std::vector<double>& grid, double value) {
  return static_cast<std::size_t>(std::lower_bound(grid.begin(), grid.end(), value) - grid.begin());
}

enum class Bound { kPositive, kNotNegative };

void check_sign(const CsvFile& csv, const std::string& name, const std::vector<double>& values, Bound bound,
                std::vector<Fault>& faults) {
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (values[k] > 0 || (bound == Bound::kNotNegative && values[k] == 0)) continue;
    faults.push_back({csv.cell_mark(k, *csv.find(name)), "the " + name + " is not positive", ""});
    return;
  }
}

/// Checks that all densities are in the range of lubricant.density.
void check_density(const CsvFile& csv, const std::vector<double>& density, std::vector<Fault>& faults) {
  const auto found = std::find_if_not(density.begin(), density.end(), cycle::is_oil_density);
  if (found == density.end()) return;
  faults.push_back({csv.cell_mark(static_cast<std::size_t>(found - density.begin()), *csv.find("density")),
                    fmt::format("the density is {:.6g} kg/m3, out of range", *found),
                    std::string(cycle::kAllowedOilDensity) + "; is the unit in the header right?"});
}

}  // namespace

OilFile read_oil_table(const NamedFile& file, const Units& units) {
  const CsvFile csv = read_csv(file);
  std::vector<Fault> faults;
  const auto column = [&](const char* name, const char* si_unit, const char* example) {
    return quantity_column(csv, name, si_unit, example, units, faults);
  };
  const std::vector<double> T = column("temperature", "K", "temperature [degC]");
  const std::vector<double> p = column("pressure", "Pa", "pressure [Pa]");
  const std::vector<double> eta = column("viscosity", "Pa s", "viscosity [Pa s]");
  const std::vector<double> rho = column("density", "kg/m3", "density [kg/m3]");
  if (!faults.empty()) throw InputError(faults);
  check_sign(csv, "temperature", T, Bound::kPositive, faults);
  check_sign(csv, "pressure", p, Bound::kNotNegative, faults);
  check_sign(csv, "viscosity", eta, Bound::kPositive, faults);
  check_density(csv, rho, faults);

  OilFile oil;
  oil.table.temperature = sorted_unique(T);
  oil.table.pressure = sorted_unique(p);
  const std::size_t n_T = oil.table.temperature.size(), n_p = oil.table.pressure.size();
  const SourceMark whole = csv.source.mark(0);
  if (n_p < 2) faults.push_back({whole, "the table has only one pressure", "two or more are required"});
  if (faults.empty() && T.size() < n_T * n_p) {
    faults.push_back({whole,
                      fmt::format("the table has {} rows for {} temperatures and {} pressures", T.size(), n_T, n_p),
                      "every pressure is required at every temperature"});
  }
  if (!faults.empty()) throw InputError(faults);
  oil.table.viscosity.assign(n_T * n_p, 0.0);
  oil.table.density.assign(n_T * n_p, 0.0);
  for (std::size_t k = 0; k < T.size(); ++k) {
    const std::size_t i = index_of(oil.table.temperature, T[k]) * n_p + index_of(oil.table.pressure, p[k]);
    if (oil.table.viscosity[i] != 0) {
      faults.push_back({csv.cell_mark(k, 0), "this temperature and pressure come twice", "keep one of the rows"});
      throw InputError(faults);
    }
    oil.table.viscosity[i] = eta[k];
    oil.table.density[i] = rho[k];
  }
  oil.sha256 = csv.source.sha256;
  oil.notes = csv.notes;
  return oil;
}

}  // namespace ringfilm::io
