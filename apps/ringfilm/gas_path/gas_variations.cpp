#include "gas_path/gas_variations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

#include "faults.hpp"
#include "ringfilm/base/trimmed.hpp"
#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/cycle/pack/gas_quantities.hpp"
#include "ringfilm/io/gas_path/gas_path_output.hpp"
#include "ringfilm/run/run.hpp"

namespace ringfilm::app {
namespace {

/// More would be a study of hours.
constexpr std::size_t kMaxCombinations = 10000;

/// The settings of a combination, by its number.
std::vector<io::Override> combination(const std::vector<Variation>& varied, std::size_t number) {
  std::vector<io::Override> settings(varied.size());
  for (std::size_t i = varied.size(); i-- > 0;) {
    const std::size_t n = varied[i].values.size();
    settings[i] = {varied[i].key, varied[i].values[number % n], "--vary"};
    number /= n;
  }
  return settings;
}

std::string quoted_cell(const std::string& text) {
  std::string cell = "\"";
  for (const char c : text) cell += c == '"' ? "\"\"" : std::string(1, c);
  return cell + "\"";
}

/// A case of each combination; whatever is wrong with one is reported before anything is computed.
std::vector<cycle::Case> cases_of(const std::string& path, const std::vector<io::Override>& overrides,
                                  const std::vector<Variation>& varied, std::size_t n) {
  const io::Units units;
  std::vector<cycle::Case> cases;
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<io::Override> settings = overrides;
    std::ranges::copy(combination(varied, i), std::back_inserter(settings));
    std::vector<io::DroppedKey> dropped;
    cases.push_back(io::read_case_dropping(path, settings, units, dropped, cycle::CasePurpose::kGasPath));
  }
  return cases;
}

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

/// Refuses what varies nothing, or what --set fixes.
void check_varied(const std::vector<Variation>& varied, const std::vector<io::Override>& overrides) {
  Faults faults;
  for (const Variation& one : varied) {
    if (std::ranges::find(overrides, one.key, &io::Override::key) != overrides.end()) {
      faults.refuse(one.key + " is stated by --set and by --vary", "keep one of them");
    } else if (!acts_on_gas(one.key)) {
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

std::vector<Variation> variations(const std::vector<std::string>& texts) {
  std::vector<Variation> all;
  std::set<std::string> keys;
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    Variation one{std::string(trimmed(text.substr(0, equals))), {}};
    std::size_t begin = equals == std::string::npos ? text.size() : equals + 1;
    while (begin < text.size()) {
      const std::size_t end = std::min(text.find(',', begin), text.size());
      one.values.emplace_back(trimmed(text.substr(begin, end - begin)));
      begin = end + 1;
    }
    const bool has_values = !one.values.empty() && std::ranges::none_of(one.values, &std::string::empty);
    if (one.key.empty() || !has_values) {
      throw InputError("--vary " + text + " is not a key with its values",
                       "write, for example, --vary operating.speed='1000 rpm, 2000 rpm'");
    }
    if (!keys.insert(one.key).second) throw InputError("--vary " + one.key + " is given twice", "keep one of them");
    all.push_back(std::move(one));
  }
  return all;
}

std::string gas_variations_csv(const std::string& case_path, const std::vector<io::Override>& overrides,
                               const std::vector<Variation>& varied) {
  check_varied(varied, overrides);
  std::size_t n = 1;
  for (const Variation& one : varied) n *= one.values.size();
  if (n > kMaxCombinations) {
    throw InputError(fmt::format("--vary makes {} combinations, {} at the most are computed", n, kMaxCombinations),
                     "vary fewer values");
  }
  const std::vector<cycle::Case> cases = cases_of(case_path, overrides, varied, n);
  std::vector<Row> rows;
  for (std::size_t i = 0; i < n; ++i) {
    Row row{combination(varied, i), std::nullopt, ""};
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
