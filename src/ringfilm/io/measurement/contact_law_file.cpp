#include "ringfilm/io/measurement/contact_law_file.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>

#include "ringfilm/base/error.hpp"
#include "ringfilm/base/number_text.hpp"
#include "ringfilm/io/result/result_file_reader.hpp"
#include "ringfilm/io/storage/digest.hpp"
#include "ringfilm/io/storage/digest_trailer.hpp"
#include "ringfilm/models/contact/tabulated_contact.hpp"

namespace ringfilm::io {
namespace {

constexpr std::size_t kMaxFile = std::size_t{1} << 30;  // [byte]; a contact map of 8192 x 8192 points

[[noreturn]] void refuse(const NamedFile& file, const std::string& what, const std::string& remedy) {
  throw InputError(std::vector<Fault>{{{file.shown, 0, 0, ""}, what, remedy}});
}

constexpr const char* kColumns[] = {"separation", "contact_pressure", "real_area", "mean_gap"};
constexpr const char* kFlowColumns[] = {"phi_x", "phi_y", "phi_s", "phi_fp"};
constexpr const char* kValues[] = {"composite_roughness", "composite_modulus", kLastSupportedSeparation};
constexpr const char* kOptionalValues[] = {"hardness", kShiftDeviation, kLogPressureDeviation,
                                           kShiftPressureCorrelation};

/// The numbers of a contact law as its document holds them, in the order of its rows.
struct LawNumbers {
  std::map<std::string, std::vector<double>> columns;  ///< without those of the flow where the document has none
  std::map<std::string, double> values;
  std::vector<double> gap;                     ///< places of the true gap; empty without the flow [m]
  std::vector<std::vector<double>> gap_share;  ///< distribution of the true gap over `gap` for each row
};

std::vector<std::size_t> rising_order(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  return order;
}

/// The flow through the gap, in the order of the separations; nothing where there is none.
std::optional<models::FlowTable> flow_of(const LawNumbers& numbers) {
  if (!numbers.columns.contains("phi_x")) return std::nullopt;
  const std::vector<std::size_t> order = rising_order(numbers.columns.at("separation"));
  const auto sorted = [&](const char* name) {
    std::vector<double> of;
    for (const std::size_t k : order) of.push_back(numbers.columns.at(name)[k]);
    return of;
  };
  models::FlowTable flow{sorted("separation"),
                         sorted("phi_x"),
                         sorted("phi_y"),
                         sorted("phi_s"),
                         sorted("phi_fp"),
                         sorted("mean_gap"),
                         numbers.gap,
                         {},
                         numbers.values.at("composite_roughness")};
  for (const std::size_t k : order) flow.gap_share.push_back(numbers.gap_share[k]);
  return flow;
}

/// Rows by their separation, of those with contact.
cycle::ContactLawTable rows_with_contact(const LawNumbers& numbers) {
  const auto& column = numbers.columns;
  cycle::ContactLawTable law;
  for (const std::size_t k : rising_order(column.at("separation"))) {
    if (!(column.at("contact_pressure")[k] > 0)) continue;
    law.rows.h.push_back(column.at("separation")[k]);
    law.rows.pressure.push_back(column.at("contact_pressure")[k]);
    law.rows.area_share.push_back(column.at("real_area")[k]);
    law.mean_gap.push_back(column.at("mean_gap")[k]);
  }
  return law;
}

/// What a case makes of the numbers. Throws InputError where they are not a law.
ContactLawFile law_of(const LawNumbers& numbers) {
  ContactLawFile of;
  of.law = rows_with_contact(numbers);
  of.law.composite_roughness = numbers.values.at("composite_roughness");
  of.law.composite_modulus = numbers.values.at("composite_modulus");
  of.law.last_supported_separation = numbers.values.at(kLastSupportedSeparation);
  const auto maybe = [&](const char* name) {
    const auto found = numbers.values.find(name);
    return found == numbers.values.end() ? std::nullopt : std::optional(found->second);
  };
  of.law.hardness = maybe("hardness");
  of.law.shift_deviation = maybe(kShiftDeviation);
  of.law.factor_deviation = maybe(kLogPressureDeviation);
  of.law.shift_factor_correlation = maybe(kShiftPressureCorrelation);
  if (auto flow = flow_of(numbers)) of.law.flow = std::make_shared<const models::MeasuredFlow>(std::move(*flow));
  const models::TabulatedContact contact(of.law.rows, of.law.last_supported_separation);
  if (contact.row_error() > models::TabulatedContact::kMaxError) {
    of.notes.push_back("contact.law: between its rows the law errs by up to " + number_text(contact.row_error()) +
                       " of the pressure of a row: compute more separations");
  }
  return of;
}

LawNumbers numbers_of(const ResultFileReader& file) {
  LawNumbers numbers;
  const std::string prefix = std::string(kContactLawTable) + "_";
  const auto read = [&](const std::string& axis, const std::string& name, std::vector<double>& to) {
    file.numbers({axis.c_str()}, {name, "", "", "", "", ""}, to);
  };
  for (const char* name : kColumns) read(prefix + "row", prefix + name, numbers.columns[name]);
  for (const char* name : kValues) file.scalar({name, "", "", "", "", ""}, numbers.values[name]);
  for (const char* name : kOptionalValues) {
    if (file.has_variable(name)) file.scalar({name, "", "", "", "", ""}, numbers.values[name]);
  }
  if (!file.has_variable(prefix + "phi_x")) return numbers;
  for (const char* name : kFlowColumns) read(prefix + "row", prefix + name, numbers.columns[name]);
  const std::string along = std::string(kGapDistribution) + "_gap";
  read(along, along, numbers.gap);
  for (std::size_t k = 0; k < numbers.columns.at("separation").size(); ++k) {
    read(along, std::string(kGapDistribution) + "_" + gap_series(k), numbers.gap_share.emplace_back());
  }
  return numbers;
}

LawNumbers numbers_of(const Measurement& law) {
  LawNumbers numbers;
  for (const MeasuredTable& table : law.tables) {
    if (table.name != kContactLawTable) continue;
    for (std::size_t k = 0; k < table.columns.size(); ++k) numbers.columns[table.columns[k].name] = table.values[k];
  }
  for (const MeasuredGroup& group : law.groups) {
    for (const MeasuredValue& value : group.values) numbers.values[value.name] = value.value;
  }
  for (const MeasuredCurve& curve : law.curves) {
    if (curve.name != kGapDistribution) continue;
    numbers.gap = curve.x;
    for (const MeasuredSeries& series : curve.series) numbers.gap_share.push_back(series.y);
  }
  return numbers;
}

}  // namespace

std::string gap_series(std::size_t row) { return "h" + std::to_string(row); }

ContactLawFile read_contact_law(const NamedFile& named) {
  const std::string bytes = read_source_bytes(named.path, named.shown, kMaxFile);
  const char* remedy = "write one with ringfilm contact --surface ... --output law.nc";
  LawNumbers numbers;
  {
    ResultFileReader file(named.shown, content_before_trailer(named.shown, bytes));
    if (!file.has_attribute("ringfilm_measurement_schema")) refuse(named, "is not a contact law", remedy);
    std::string kind;
    file.attribute("kind", kind);
    if (kind != kContactLawKind) refuse(named, "is the measurement of a " + kind + ", not a contact law", remedy);
    numbers = numbers_of(file);
  }
  try {
    ContactLawFile of = law_of(numbers);
    of.sha256 = sha256(bytes);
    return of;
  } catch (const InputError& fault) {
    refuse(named, fault.faults().front().message, fault.faults().front().remedy);
  }
}

void check_contact_law(const Measurement& law) {
  try {
    law_of(numbers_of(law));
  } catch (const InputError& fault) {
    throw InputError("contact.model = \"table\" does not read this law: " + fault.faults().front().message,
                     fault.faults().front().remedy + "; larger maps and more --shifts make it smoother");
  }
}

}  // namespace ringfilm::io
