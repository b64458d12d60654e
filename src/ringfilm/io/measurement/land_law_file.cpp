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

constexpr const char* kLandColumns[] = {"separation", "lift", "friction_factor", "lowest_gap"};
constexpr const char* kLandValues[] = {"land_width", "speed", "viscosity", "roughness", "speed_exponent"};

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
  for (const char* name : kLandColumns) {
    file.numbers({row.c_str()}, {prefix + name, "", "", "", "", ""}, numbers.columns[name]);
  }
  for (const char* name : kLandValues) file.scalar({name, "", "", "", "", ""}, numbers.values[name]);
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

struct LandCsvColumn {
  const char *name, *unit, *example;
  bool is_needed;
};

constexpr LandCsvColumn kLandCsvRows[] = {{"separation", "m", "separation [um]", true},
                                          {"lift", "Pa", "lift [kPa]", true},
                                          {"friction_factor", "1", "friction_factor [-]", true},
                                          {"lowest_gap", "m", "lowest_gap [um]", true},
                                          {"lift_scatter", "Pa", "lift_scatter [kPa]", false}};
constexpr LandCsvColumn kLandCsvValues[] = {{"land_width", "m", "land_width [mm]", true},
                                            {"speed", "m/s", "speed [m/s]", true},
                                            {"viscosity", "Pa s", "viscosity [mPa s]", true},
                                            {"roughness", "m", "roughness [um]", true},
                                            {"speed_exponent", "1", "speed_exponent [-]", true}};

/// A table of the same columns, in which what is one value of the land has it in each row.
LandLawFile read_land_csv(const NamedFile& named, const Units& units) {
  const CsvFile csv = read_csv(named);
  std::vector<Fault> faults;
  LandNumbers numbers;
  const auto column = [&](const LandCsvColumn& of) {
    if (!of.is_needed && !csv.find(of.name)) return std::vector<double>();
    return quantity_column(csv, of.name, of.unit, of.example, units, faults);
  };
  for (const LandCsvColumn& of : kLandCsvRows) numbers.columns[of.name] = column(of);
  for (const LandCsvColumn& of : kLandCsvValues) {
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
  const std::vector<double>&scatter = numbers.columns["lift_scatter"], &lift = numbers.columns["lift"];
  if (!scatter.empty()) {
    double squares = 0, n = 0;
    for (std::size_t k = 0; k < scatter.size(); ++k) {
      if (!(lift[k] > 0)) continue;
      squares += std::pow(scatter[k] / lift[k], 2);
      n += 1;
    }
    if (n > 0) numbers.values[kLogLiftDeviation] = std::sqrt(squares / n);
  }
  try {
    LandLawFile of = land_law_of(numbers);
    of.sha256 = csv.source.sha256;
    of.notes.insert(of.notes.begin(), csv.notes.begin(), csv.notes.end());
    return of;
  } catch (const InputError& fault) {
    refuse_land(named, fault.faults().front().message, fault.faults().front().remedy);
  }
}

}  // namespace

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
  try {
    LandLawFile of = land_law_of(numbers);
    of.sha256 = sha256(bytes);
    return of;
  } catch (const InputError& fault) {
    refuse_land(named, fault.faults().front().message, fault.faults().front().remedy);
  }
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
