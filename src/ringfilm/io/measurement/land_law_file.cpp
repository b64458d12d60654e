#include "ringfilm/io/measurement/land_law_file.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <numeric>

#include "ringfilm/base/error.hpp"
#include "ringfilm/base/number_text.hpp"
#include "ringfilm/io/result/result_file_reader.hpp"
#include "ringfilm/io/storage/digest.hpp"
#include "ringfilm/io/storage/digest_trailer.hpp"
#include "ringfilm/io/table/csv_quantity.hpp"
#include "ringfilm/models/land/land_lift.hpp"

namespace ringfilm::io {
namespace {

constexpr std::size_t kMaxLandFile = std::size_t{1} << 28;  // [byte]

[[noreturn]] void refuse_land(const NamedFile& file, const std::string& what, const std::string& remedy) {
  throw InputError(std::vector<Fault>{{{file.shown, 0, 0, ""}, what, remedy}});
}

/// What a case reads of a land, in NetCDF in SI under these names, in CSV in any unit of the kind.
struct LandColumn {
  const char *name, *unit, *example;
};

constexpr LandColumn kLandColumns[] = {{"separation", "m", "separation [um]"},
                                       {"lift", "Pa", "lift [kPa]"},
                                       {"friction_factor", "1", "friction_factor [-]"},
                                       {"lowest_gap", "m", "lowest_gap [um]"}};
constexpr LandColumn kLandValues[] = {{"land_width", "m", "land_width [mm]"},
                                      {"speed", "m/s", "speed [m/s]"},
                                      {"viscosity", "Pa s", "viscosity [mPa s]"},
                                      {"roughness", "m", "roughness [um]"},
                                      {"speed_exponent", "1", "speed_exponent [-]"}};
constexpr LandColumn kLandScatter = {"lift_scatter", "Pa", "lift_scatter [kPa]"};

/// The numbers of a land as its document holds them, in the order of its rows.
struct LandNumbers {
  std::map<std::string, std::vector<double>> columns;
  std::map<std::string, double> values;
};

/// What a case makes of the numbers. Throws InputError where they are not a law.
LandLawFile land_law_of(const LandNumbers& numbers) {
  const auto& column = numbers.columns;
  const std::vector<double>&separation = column.at("separation"), &lift = column.at("lift");
  std::vector<std::size_t> order(separation.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return separation[a] < separation[b]; });
  LandLawFile of;
  std::size_t omitted = 0;
  bool is_over = false;  // from the first separation without lift on
  for (const std::size_t k : order) {
    is_over = is_over || !(lift[k] > 0);
    if (is_over) {
      ++omitted;
      continue;
    }
    models::LandTable& rows = of.law.rows;
    if (rows.separation.empty()) of.law.lowest_gap = column.at("lowest_gap")[k];
    rows.separation.push_back(separation[k]);
    rows.lift.push_back(lift[k]);
    rows.friction_factor.push_back(column.at("friction_factor")[k]);
  }
  if (omitted > 0) {
    of.notes.push_back("film.land_law: " + number_text(static_cast<double>(omitted)) +
                       " of its separations have no lift and are omitted");
  }
  of.law.rows.speed_viscosity = numbers.values.at("speed") * numbers.values.at("viscosity");
  of.law.rows.speed_exponent = numbers.values.at("speed_exponent");
  of.law.width = numbers.values.at("land_width");
  of.law.roughness = numbers.values.at("roughness");
  if (const auto found = numbers.values.find(kLogLiftDeviation); found != numbers.values.end()) {
    of.law.log_lift_deviation = found->second;
  }
  static_cast<void>(models::LandLift(of.law.rows));
  return of;
}

LandNumbers land_numbers_of(const ResultFileReader& file) {
  LandNumbers numbers;
  const std::string prefix = std::string(kLandLawTable) + "_", row = prefix + "row";
  for (const LandColumn& of : kLandColumns) {
    file.numbers({row.c_str()}, {prefix + of.name, "", "", "", "", ""}, numbers.columns[of.name]);
  }
  for (const LandColumn& of : kLandValues) file.scalar({of.name, "", "", "", "", ""}, numbers.values[of.name]);
  if (file.has_variable(kLogLiftDeviation)) {
    file.scalar({kLogLiftDeviation, "", "", "", "", ""}, numbers.values[kLogLiftDeviation]);
  }
  return numbers;
}

LandNumbers land_numbers_of(const Measurement& law) {
  LandNumbers numbers;
  for (const MeasuredTable& table : law.tables) {
    if (table.name != kLandLawTable) continue;
    for (std::size_t k = 0; k < table.columns.size(); ++k) numbers.columns[table.columns[k].name] = table.values[k];
  }
  for (const MeasuredGroup& group : law.groups) {
    for (const MeasuredValue& value : group.values) numbers.values[value.name] = value.value;
  }
  return numbers;
}

/// The law of the numbers, with their file in what is refused.
LandLawFile land_law_of(const LandNumbers& numbers, const NamedFile& named, const std::string& digest) {
  try {
    LandLawFile of = land_law_of(numbers);
    of.sha256 = digest;
    return of;
  } catch (const InputError& fault) {
    refuse_land(named, fault.faults().front().message, fault.faults().front().remedy);
  }
}

/// A table of the same columns, in which what is one value of the land has it in each row.
LandLawFile read_land_csv(const NamedFile& named, const Units& units) {
  const CsvFile csv = read_csv(named);
  std::vector<Fault> faults;
  LandNumbers numbers;
  const auto column = [&](const LandColumn& of) {
    return quantity_column(csv, of.name, of.unit, of.example, units, faults);
  };
  for (const LandColumn& of : kLandColumns) numbers.columns[of.name] = column(of);
  const std::vector<double> scatter = csv.find(kLandScatter.name) ? column(kLandScatter) : std::vector<double>();
  for (const LandColumn& of : kLandValues) {
    const std::vector<double> rows = column(of);
    if (rows.empty()) continue;
    numbers.values[of.name] = rows.front();
    const auto other = std::adjacent_find(rows.begin(), rows.end(), std::not_equal_to<>());
    if (other == rows.end()) continue;
    faults.push_back({csv.cell_mark(static_cast<std::size_t>(other - rows.begin()) + 1, *csv.find(of.name)),
                      std::string(of.name) + " is another one than in the row before",
                      "a table is that of one land at one speed and one viscosity: write a file for each"});
  }
  if (!faults.empty()) throw InputError(faults);
  const double deviation = log_lift_deviation(numbers.columns["lift"], scatter);
  if (std::isfinite(deviation)) numbers.values[kLogLiftDeviation] = deviation;
  LandLawFile of = land_law_of(numbers, named, csv.source.sha256);
  of.notes.insert(of.notes.begin(), csv.notes.begin(), csv.notes.end());
  return of;
}

}  // namespace

double log_lift_deviation(const std::vector<double>& lift, const std::vector<double>& scatter) {
  double squares = 0, n = 0;
  for (std::size_t k = 0; k < scatter.size(); ++k) {
    if (!(lift[k] > 0)) continue;
    squares += std::pow(scatter[k] / lift[k], 2);
    n += 1;
  }
  return n > 0 ? std::sqrt(squares / n) : std::nan("");
}

LandLawFile read_land_law(const NamedFile& named, const Units& units) {
  std::string ending = std::filesystem::path(named.path).extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  if (ending == ".csv") return read_land_csv(named, units);
  const std::string bytes = read_source_bytes(named.path, named.shown, kMaxLandFile);
  const char* remedy = "write one with ringfilm land --surface ... --output land.nc";
  LandNumbers numbers;
  {
    ResultFileReader file(named.shown, content_before_trailer(named.shown, bytes));
    if (!file.has_attribute("ringfilm_measurement_schema")) refuse_land(named, "is not the law of a land", remedy);
    std::string kind;
    file.attribute("kind", kind);
    if (kind != kLandLawKind) refuse_land(named, "is the measurement of a " + kind + ", not of a land", remedy);
    numbers = land_numbers_of(file);
  }
  return land_law_of(numbers, named, sha256(bytes));
}

void check_land_law(const Measurement& law) {
  try {
    land_law_of(land_numbers_of(law));
  } catch (const InputError& fault) {
    throw InputError("film.land_lift = \"table\" does not read this law: " + fault.faults().front().message,
                     fault.faults().front().remedy);
  }
}

}  // namespace ringfilm::io
