#include "ringfilm/io/result/result_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "ringfilm/io/result/result_document.hpp"

namespace ringfilm::io {
namespace {

std::string exact_number(double value) {
  return std::isnan(value) ? "nan" : fmt::format("{}", value + 0.0);  // the sign of a NaN or a zero has no meaning
}

/// What a column of the curves is of all rings together.
enum class OfPack { kSum, kSameOfEachRing, kNone };

OfPack of_pack(const cycle::CurveQuantity& quantity) {
  static const std::set<std::string> sums = {
      "hydrodynamic_load",     "asperity_load",  "boundary_friction", "viscous_friction", "viscous_friction_liner",
      "viscous_friction_ring", "total_friction", "friction_on_liner", "power_loss",       "archard_wear_load_rate",
      "applied_load"};
  static const std::set<std::string> of_engine = {"crank_angle", "piston_position", "piston_velocity",
                                                  "sliding_distance"};
  if (sums.contains(quantity.name)) return OfPack::kSum;
  return of_engine.contains(quantity.name) ? OfPack::kSameOfEachRing : OfPack::kNone;
}

struct Column {
  std::string header;
  OfPack of_pack = OfPack::kNone;
  std::vector<double> values;
};

using Errors = std::optional<study::ErrorEstimate>;

std::vector<Column> columns_of(const std::vector<cycle::Sample>& samples, const Errors& errors,
                               const std::vector<cycle::UnrolledSample>& unrolled) {
  std::vector<Column> columns;
  const auto add = [&columns](const std::string& name, const std::string& unit, OfPack kind, const auto& rows,
                              auto member) {
    Column& column = columns.emplace_back(Column{unit == "1" ? name : name + " [" + unit + "]", kind, {}});
    for (const auto& row : rows) column.values.push_back(row.*member);
  };
  for (const auto& q : cycle::curve_quantities()) add(q.name, q.unit, of_pack(q), samples, q.value);
  for (const auto& q : cycle::unrolled_quantities()) {
    if (!unrolled.empty()) add(q.name, q.unit, OfPack::kNone, unrolled, q.value);
  }
  for (const auto& q : cycle::curve_quantities()) {
    if (errors && study::has_values(*errors) && study::has_error(q))
      add(q.name + "_error", q.unit, OfPack::kNone, errors->samples, q.value);
  }
  return columns;
}

std::vector<Column> columns_of(const ResultDocument& ring) {
  return columns_of(ring.result.samples, ring.errors, ring.result.unrolled_samples);
}

std::string header_of(const std::vector<Column>& columns) {
  std::string line;
  for (const Column& column : columns) line += (line.empty() ? "" : ",") + column.header;
  return line + "\n";
}

std::string row_of(const std::vector<Column>& columns, std::size_t k) {
  std::string line;
  for (const Column& column : columns) line += (line.empty() ? "" : ",") + exact_number(column.values[k]);
  return line + "\n";
}

/// The sums over all rings, where each has been computed for the same crank angles; else no rows.
std::vector<Column> columns_of_all(const ResultDocument& pack) {
  std::vector<Column> all = columns_of(pack.rings.front());
  const std::size_t n = all.front().values.size();
  const auto has_all = [&](const ResultDocument& ring) { return ring.result.samples.size() == n; };
  if (pack.rings.size() < 2 || !pack.result.complete || !std::ranges::all_of(pack.rings, has_all)) return {};
  for (Column& column : all) {
    if (column.of_pack != OfPack::kSameOfEachRing)
      column.values.assign(n, column.of_pack == OfPack::kSum ? 0 : std::numeric_limits<double>::quiet_NaN());
  }
  for (const ResultDocument& ring : pack.rings) {
    const std::vector<Column> own = columns_of(ring);
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (all[i].of_pack != OfPack::kSum) continue;
      for (std::size_t k = 0; k < n; ++k) all[i].values[k] += own[i].values[k];
    }
  }
  return all;
}

}  // namespace

std::string result_csv(const std::vector<cycle::Sample>& samples, const Errors& errors,
                       const std::vector<cycle::UnrolledSample>& unrolled) {
  const std::vector<Column> columns = columns_of(samples, errors, unrolled);
  std::string csv = header_of(columns);
  for (std::size_t k = 0; k < samples.size(); ++k) csv += row_of(columns, k);
  return csv;
}

std::string result_csv(const ResultDocument& document) {
  if (!document.is_pack())
    return result_csv(document.result.samples, document.errors, document.result.unrolled_samples);
  std::string csv = "ring," + header_of(columns_of(document.rings.front()));
  const auto add = [&csv](const std::string& ring, const std::vector<Column>& columns) {
    for (std::size_t k = 0; !columns.empty() && k < columns.front().values.size(); ++k)
      csv += ring + "," + row_of(columns, k);
  };
  const std::vector<std::size_t> numbers = ring_numbers(document);
  for (std::size_t i = 0; i < document.rings.size(); ++i) {
    const long rail = document.rings[i].rail;
    add(fmt::format("{}{}", numbers[i], rail > 0 ? fmt::format(".{}", rail) : ""), columns_of(document.rings[i]));
  }
  add("all", columns_of_all(document));
  return csv;
}

}  // namespace ringfilm::io
