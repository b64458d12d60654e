#include "gas_path/gas_variations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>

#include "ringfilm/base/trimmed.hpp"
#include "ringfilm/io/gas_path/gas_path_output.hpp"

namespace ringfilm::app {
namespace {

/// More would be a study of hours.
constexpr std::size_t kMostCombinations = 10000;
constexpr double kLitresPerMinute = 6e4;  // of 1 m3/s

/// The settings of a combination, by its number.
std::vector<io::Override> combination(const std::vector<Variation>& varied, std::size_t number) {
  std::vector<io::Override> settings(varied.size());
  for (std::size_t i = varied.size(); i-- > 0;) {
    const std::size_t n = varied[i].values.size();
    settings[i] = {varied[i].key, varied[i].values[number % n]};
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

std::string head(const std::vector<Variation>& varied, const gas_path::GasPathResult& result) {
  std::string row;
  for (const Variation& one : varied) row += one.key + ",";
  row += "blow_by_per_cycle [kg],blow_by_flow [l/min]";
  for (const gas_path::RegionValues& region : result.regions) {
    std::string name = region.name;
    std::replace(name.begin(), name.end(), ' ', '_');
    row += ",peak_pressure_" + name + " [Pa]";
  }
  return row + ",fluttering_rings,period_in_cycles,reason\n";
}

std::string values(const io::GasPathDocument& document) {
  const gas_path::GasPathResult& result = document.result;
  std::string row = fmt::format("{},{}", result.blow_by, document.blow_by_flow * kLitresPerMinute);
  for (const gas_path::RegionValues& region : result.regions) row += fmt::format(",{}", region.peak_pressure);
  const auto n_flutter = std::ranges::count_if(result.motion, [](const auto& ring) { return ring.flutters; });
  return row + fmt::format(",{},{},", n_flutter, result.period);
}

}  // namespace

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
  std::size_t n = 1;
  for (const Variation& one : varied) n *= one.values.size();
  if (n > kMostCombinations) {
    throw InputError(fmt::format("--vary makes {} combinations, {} at the most are computed", n, kMostCombinations),
                     "vary fewer values");
  }
  const std::vector<cycle::Case> cases = cases_of(case_path, overrides, varied, n);
  std::string csv;
  std::size_t n_cells = 0;
  for (std::size_t i = 0; i < n; ++i) {
    std::string row;
    for (const io::Override& setting : combination(varied, i)) row += quoted_cell(setting.value) + ",";
    try {
      const io::GasPathDocument document = io::gas_path_document(cases[i]);
      if (n_cells == 0) {
        const std::string first = head(varied, document.result);
        n_cells = static_cast<std::size_t>(std::ranges::count(first, ','));
        csv = first + csv;
      }
      csv += row + values(document) + "\n";
    } catch (const ConvergenceError& error) {
      csv += row + std::string(n_cells > varied.size() ? n_cells - varied.size() : 0, ',') + quoted_cell(error.what()) +
             "\n";
    }
  }
  return csv;
}

}  // namespace ringfilm::app
