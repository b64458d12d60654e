#include "gas_path/gas_variations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "faults.hpp"
#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/cycle/pack/gas_quantities.hpp"
#include "ringfilm/io/gas_path/gas_path_output.hpp"
#include "ringfilm/run/run.hpp"

namespace ringfilm::app {
namespace {

/// What the gas of a combination is.
struct Solution {
  gas_path::GasSums sums;
  std::vector<gas_path::RegionValues> regions;  ///< those of this combination
  std::ptrdiff_t fluttering_rings = 0;
};

/// A combination and what was found of it.
struct Row {
  std::vector<io::Override> settings;
  std::optional<Solution> solution;  ///< nothing where it was not solved
  std::string reason;                ///< why
};

Solution solution_of(const cycle::Case& c) {
  auto document = std::get<io::GasPathDocument>(run::run_case(c).result);
  gas_path::GasPathResult& result = document.result;
  Solution solution;
  solution.sums = document.gas.sums;
  solution.regions = std::move(result.regions);
  solution.fluttering_rings = std::ranges::count_if(result.motion, [](const auto& ring) { return ring.flutters; });
  return solution;
}

/// Names of the regions of all combinations, from the chamber to the crankcase: volumes that are 0 have none.
std::vector<std::string> region_names(const std::vector<Row>& rows) {
  std::vector<std::string> names;
  for (const Row& row : rows) {
    if (!row.solution) continue;
    std::ptrdiff_t next = 0;  // where a name belongs that no combination before had
    for (const gas_path::RegionValues& region : row.solution->regions) {
      auto at = std::find(names.begin(), names.end(), region.name);
      if (at == names.end()) at = names.insert(names.begin() + next, region.name);
      next = at - names.begin() + 1;
    }
  }
  return names;
}

/// Sums that a combination has: without a composition of the gas those of fuel and water are missing.
std::vector<cycle::GasSumQuantity> sums_of(const std::vector<Row>& rows) {
  std::vector<cycle::GasSumQuantity> found;
  for (const cycle::GasSumQuantity& quantity : cycle::gas_sum_quantities()) {
    const bool is_missing = std::ranges::none_of(
        rows, [&](const Row& row) { return row.solution && cycle::number_of(quantity, row.solution->sums); });
    if (!is_missing || !needs_composition(quantity)) found.push_back(quantity);
  }
  return found;
}

std::string head(const std::vector<Variation>& varied, const std::vector<cycle::GasSumQuantity>& sums,
                 const std::vector<std::string>& regions) {
  std::string line;
  for (const Variation& one : varied) line += one.key + ",";
  for (const cycle::GasSumQuantity& quantity : sums) {
    line += quantity.name + (quantity.unit == "1" ? "," : " [" + quantity.unit + "],");
  }
  for (std::string name : regions) {
    std::replace(name.begin(), name.end(), ' ', '_');
    line += "peak_pressure_" + name + " [Pa],";
  }
  return line + "fluttering_rings,reason\n";
}

/// The values of a combination, in the columns of these regions.
std::string values(const Solution& solution, const std::vector<cycle::GasSumQuantity>& sums,
                   const std::vector<std::string>& regions) {
  std::string line;
  for (const cycle::GasSumQuantity& quantity : sums) {
    const std::optional<double> value = cycle::number_of(quantity, solution.sums);
    line += value ? fmt::format("{},", *value) : ",";
  }
  for (const std::string& name : regions) {
    const auto region = std::ranges::find(solution.regions, name, &gas_path::RegionValues::name);
    line += region == solution.regions.end() ? "," : fmt::format("{},", region->peak_pressure);
  }
  return line + fmt::format("{},", solution.fluttering_rings);
}

std::string line_of(const Row& row, const std::vector<cycle::GasSumQuantity>& sums,
                    const std::vector<std::string>& regions) {
  std::string line;
  for (const io::Override& setting : row.settings) line += quoted_cell(setting.value) + ",";
  if (row.solution) return line + values(*row.solution, sums, regions) + "\n";
  return line + std::string(sums.size() + regions.size() + 1, ',') + quoted_cell(row.reason) + "\n";
}

/// Refuses what varies nothing.
void check_varied(const std::vector<Variation>& varied) {
  Faults faults;
  for (const Variation& one : varied) {
    if (!acts_on_gas(one.key)) {
      faults.refuse("--vary " + one.key + " has no effect: the gas of a ring pack alone does not follow from it",
                    "vary a key of the engine, the gas or the rings, for example ring.1.end_gap; ringfilm study "
                    "varies keys of the films");
    }
  }
  faults.check();
}

}  // namespace

bool acts_on_gas(const std::string& key) {
  const auto of_ring = cycle::ring_key(key);
  const cycle::Field* field = cycle::find_field(of_ring ? of_ring->key : key);
  return field == nullptr || (field->uses.gas && !field->is_for_record);
}

const VariationForm& vary_form() {
  static const VariationForm form{"--vary ", "--vary operating.speed='1000 rpm, 2000 rpm'", 5};
  return form;
}

std::string gas_variations_csv(const std::string& case_path, const std::vector<io::Override>& overrides,
                               const std::vector<Variation>& varied) {
  check_varied(varied);
  const std::vector<cycle::Case> cases =
      cases_of(case_path, overrides, varied, vary_form(), cycle::CasePurpose::kGasPath);
  std::vector<Row> rows;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    Row row{combination(varied, i, vary_form()), std::nullopt, ""};
    try {
      row.solution = solution_of(cases[i]);
    } catch (const ConvergenceError& error) {
      row.reason = error.what();
    }
    rows.push_back(std::move(row));
  }
  const std::vector<std::string> regions = region_names(rows);
  const std::vector<cycle::GasSumQuantity> sums = sums_of(rows);
  std::string csv = head(varied, sums, regions);
  for (const Row& row : rows) csv += line_of(row, sums, regions);
  return csv;
}

}  // namespace ringfilm::app
