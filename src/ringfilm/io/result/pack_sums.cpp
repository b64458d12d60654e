#include "ringfilm/io/result/pack_sums.hpp"

#include <algorithm>
#include <numbers>
#include <numeric>

#include "ringfilm/io/result/result_document.hpp"

namespace ringfilm::io {
namespace {

double bore_of(const ResultDocument& ring) {
  const auto bore =
      std::ranges::find_if(ring.inputs, [](const CaseEntry& entry) { return entry.key == "engine.bore"; });
  return bore == ring.inputs.end() ? 0 : bore->value_si;
}

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

}  // namespace

std::vector<RingSums> ring_sums(const ResultDocument& pack) {
  const std::vector<std::size_t> numbers = ring_numbers(pack);
  std::vector<RingSums> all;
  for (std::size_t i = 0; i < pack.rings.size(); ++i) {
    if (all.empty() || all.back().ring != numbers[i]) all.push_back({numbers[i], {}});
    cycle::add_ring(pack.rings[i].result.values, all.back().values);
  }
  return all;
}

const std::vector<PackOilQuantity>& pack_oil_quantities() {
  static const std::vector<PackOilQuantity> table = {
      {{"liner_film_after_power_stroke", "m", "um", "mean film above the first ring after the power stroke", "h_1",
        "eq-oil-to-chamber"},
       &PackOil::film_after_power_stroke},
      {{"liner_film_after_intake_stroke", "m", "um", "mean film above the first ring after the intake stroke", "h_1",
        "eq-oil-to-chamber"},
       &PackOil::film_after_intake_stroke},
      {{"oil_left_at_tdc", "kg", "mg", "oil that the first ring leaves above it at TDC, per cycle", "m_up", "eq-bead"},
       &PackOil::left_at_tdc},
      {{"oil_to_chamber_upper_bound", "kg", "mg", "upper bound of oil to the chamber, per cycle and cylinder", "m_c",
        "eq-oil-to-chamber"},
       &PackOil::to_chamber_upper_bound}};
  return table;
}

std::optional<PackOil> pack_oil(const ResultDocument& pack) {
  if (!pack.is_pack() || !pack.result.complete) return std::nullopt;
  const ResultDocument& first = pack.rings.front();
  const cycle::StrokeProfile& stroke = first.result.stroke;
  constexpr std::size_t kPower = 0, kIntake = 2;
  const std::vector<double>&power = stroke.film_behind[kPower], &intake = stroke.film_behind[kIntake];
  const auto density = first.result.derived.find("oil_density");
  if (power.size() < 2 || intake.size() != power.size() || density == first.result.derived.end()) return std::nullopt;
  const double n = static_cast<double>(power.size()), bin = stroke.liner_position[1] - stroke.liner_position[0];
  PackOil oil;
  oil.film_after_power_stroke = sum(power) / n;
  oil.film_after_intake_stroke = sum(intake) / n;
  oil.left_at_tdc = first.result.values.oil_scraped_up;
  oil.to_chamber_upper_bound = (sum(power) + sum(intake)) * bin * std::numbers::pi * bore_of(first) * density->second;
  return oil;
}

}  // namespace ringfilm::io
