#include "ringfilm/io/measurement/contact_law_file.hpp"

#include <algorithm>
#include <numeric>

#include "ringfilm/base/error.hpp"
#include "ringfilm/base/number_text.hpp"
#include "ringfilm/io/result/result_file_reader.hpp"
#include "ringfilm/io/storage/digest.hpp"
#include "ringfilm/io/storage/digest_trailer.hpp"
#include "ringfilm/models/contact/tabulated_contact.hpp"

namespace ringfilm::io {
namespace {

constexpr std::size_t kLargestFile = std::size_t{1} << 30;  // [byte]; a contact map of 8192 x 8192 points

[[noreturn]] void refuse(const NamedFile& file, const std::string& what, const std::string& remedy) {
  throw InputError(std::vector<Fault>{{{file.shown, 0, 0, ""}, what, remedy}});
}

std::vector<double> column(const ResultFileReader& file, const std::string& name) {
  const std::string rows = std::string(kContactLawTable) + "_row";
  std::vector<double> values;
  file.numbers({rows.c_str()}, {std::string(kContactLawTable) + "_" + name, "", "", "", "", ""}, values);
  return values;
}

double scalar(const ResultFileReader& file, const char* name) {
  double value = 0;
  file.scalar({name, "", "", "", "", ""}, value);
  return value;
}

std::vector<std::size_t> rising_order(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  return order;
}

/// The flow through the gap, in the order of the separations; nothing where the file has none.
std::optional<models::FlowTable> flow_of(const ResultFileReader& file) {
  if (!file.has_variable(std::string(kContactLawTable) + "_phi_x")) return std::nullopt;
  const std::vector<std::size_t> order = rising_order(column(file, "separation"));
  const auto sorted = [&](const char* name) {
    const std::vector<double> values = column(file, name);
    std::vector<double> of;
    for (const std::size_t k : order) of.push_back(values[k]);
    return of;
  };
  models::FlowTable flow{sorted("separation"),
                         sorted("phi_x"),
                         sorted("phi_y"),
                         sorted("phi_s"),
                         sorted("phi_fp"),
                         sorted("mean_gap"),
                         {},
                         {},
                         0};
  const std::string along = std::string(kGapDistribution) + "_gap";
  file.numbers({along.c_str()}, {along, "", "", "", "", ""}, flow.gap);
  for (const std::size_t k : order) {
    file.numbers({along.c_str()}, {std::string(kGapDistribution) + "_" + gap_series(k), "", "", "", "", ""},
                 flow.gap_share.emplace_back());
  }
  flow.sigma = scalar(file, "composite_roughness");
  return flow;
}

/// Rows by their separation, of those with contact.
cycle::ContactLawTable rows_with_contact(const ResultFileReader& file) {
  const std::vector<double> h = column(file, "separation"), p = column(file, "contact_pressure"),
                            A = column(file, "real_area"), gap = column(file, "mean_gap");
  cycle::ContactLawTable law;
  for (const std::size_t k : rising_order(h)) {
    if (!(p[k] > 0)) continue;
    law.rows.h.push_back(h[k]);
    law.rows.pressure.push_back(p[k]);
    law.rows.area_share.push_back(A[k]);
    law.mean_gap.push_back(gap[k]);
  }
  return law;
}

}  // namespace

std::string gap_series(std::size_t row) { return "h" + std::to_string(row); }

ContactLawFile read_contact_law(const NamedFile& named) {
  const std::string bytes = read_source_bytes(named.path, named.shown, kLargestFile);
  const char* remedy = "write one with ringfilm contact --surface ... --output law.nc";
  ContactLawFile of;
  std::optional<models::FlowTable> flow;
  of.sha256 = sha256(bytes);
  {
    ResultFileReader file(named.shown, content_before_trailer(named.shown, bytes));
    if (!file.has_attribute("ringfilm_measurement_schema")) refuse(named, "is not a contact law", remedy);
    std::string kind;
    file.attribute("kind", kind);
    if (kind != kContactLawKind) refuse(named, "is the measurement of a " + kind + ", not a contact law", remedy);
    of.law = rows_with_contact(file);
    of.law.composite_roughness = scalar(file, "composite_roughness");
    of.law.composite_modulus = scalar(file, "composite_modulus");
    of.law.last_supported_separation = scalar(file, kLastSupportedSeparation);
    if (file.has_variable("hardness")) of.law.hardness = scalar(file, "hardness");
    const auto maybe = [&](const char* name) {
      return file.has_variable(name) ? std::optional(scalar(file, name)) : std::nullopt;
    };
    of.law.shift_deviation = maybe(kShiftDeviation);
    of.law.factor_deviation = maybe(kLogPressureDeviation);
    of.law.shift_factor_correlation = maybe(kShiftPressureCorrelation);
    flow = flow_of(file);
  }
  try {
    if (flow) of.law.flow = std::make_shared<const models::MeasuredFlow>(std::move(*flow));
    const models::TabulatedContact contact(of.law.rows, of.law.last_supported_separation);
    if (contact.row_error() > models::TabulatedContact::kMostError) {
      of.notes.push_back("contact.law: between its rows the law errs by up to " + number_text(contact.row_error()) +
                         " of the pressure of a row: compute more separations");
    }
  } catch (const InputError& fault) {
    refuse(named, fault.faults().front().message, fault.faults().front().remedy);
  }
  return of;
}

}  // namespace ringfilm::io
