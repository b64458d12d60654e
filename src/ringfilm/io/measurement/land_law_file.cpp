#include "ringfilm/io/measurement/land_law_file.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include "ringfilm/base/error.hpp"
#include "ringfilm/base/number_text.hpp"
#include "ringfilm/io/result/result_file_reader.hpp"
#include "ringfilm/io/storage/digest.hpp"
#include "ringfilm/io/storage/digest_trailer.hpp"
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

}  // namespace

LandLawFile read_land_law(const NamedFile& named) {
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
