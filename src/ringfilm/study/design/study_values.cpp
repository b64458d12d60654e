#include "ringfilm/study/design/study_values.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "ringfilm/base/find_by_name.hpp"
#include "ringfilm/cycle/pack/gas_of_pack.hpp"
#include "ringfilm/cycle/pack/gas_quantities.hpp"
#include "ringfilm/cycle/pack/oil_consumption.hpp"
#include "ringfilm/gas_path/network.hpp"

namespace ringfilm::study {
namespace {

using cycle::Quantity;

const std::vector<std::string> kMainOfCycle = {"fmep",
                                               "mean_power_loss",
                                               "mean_total_friction",
                                               "peak_total_friction",
                                               "min_film_thickness",
                                               "full_film_cycle_share",
                                               "mean_absolute_oil_flow"};

/// A value of the cycle under another name.
Quantity renamed(const std::string& value, const std::string& name, const std::string& words) {
  Quantity quantity = cycle::cycle_quantities()[*cycle::cycle_quantity_index(value)];
  quantity.name = name;
  quantity.long_name = words + quantity.long_name;
  quantity.symbol.clear();
  return quantity;
}

void append_pack(std::size_t n_rings, StudyValues& values) {
  for (const cycle::Quantity& sum : cycle::summed_quantities()) {
    values.quantities.push_back(renamed(sum.name, sum.name, "all rings: "));
  }
  values.main = {"fmep", "mean_power_loss"};
  for (std::size_t ring = 1; ring <= n_rings; ++ring) {
    for (const RingValue& value : ring_values()) {
      values.quantities.push_back(
          renamed(value.name, ring_value_name(ring, value.name), "ring " + std::to_string(ring) + ": "));
    }
    values.main.push_back(ring_value_name(ring, "fmep"));
    values.main.push_back(ring_value_name(ring, "min_film_thickness"));
  }
}

void append_gas(const cycle::Case& base, StudyValues& values) {
  for (const cycle::GasSumQuantity& quantity : cycle::gas_sum_quantities()) {
    if (base.gas.composition.is_stated() || !needs_composition(quantity)) values.quantities.push_back(quantity);
  }
  values.main.push_back(cycle::leading_gas_sum().name);
  const gas_path::Pack pack = cycle::gas_pack(base);
  const gas_path::Network network(pack, cycle::given_pressures(base));
  const std::vector<gas_path::Region>& regions = network.regions();
  for (const gas_path::Region& region : std::span(regions).subspan(1, regions.size() - 2)) {
    const std::string peak = region_value_name(region.name, "peak_pressure");
    values.quantities.push_back({peak, "Pa", "bar", region.name + ": highest pressure, absolute", "", "eq-gas-region"});
    values.quantities.push_back({region_value_name(region.name, "mean_pressure"), "Pa", "bar",
                                 region.name + ": pressure, absolute, mean over time", "", "eq-gas-region"});
    if (!region.name.starts_with("groove")) values.main.push_back(peak);
  }
  for (std::size_t ring = 0; ring < network.pack().rings.size(); ++ring) {
    if (!network.has_groove(ring)) continue;
    for (cycle::Quantity quantity : cycle::gas_ring_quantities()) {
      quantity.name = ring_value_name(ring + 1, quantity.name);
      quantity.long_name.insert(0, "ring " + std::to_string(ring + 1) + ": ");
      values.quantities.push_back(std::move(quantity));
    }
  }
}

/// Does a case, or a factor of the study, state the key?
bool is_stated(const std::string& key, const Study& study, const cycle::Case& first) {
  const auto moves = [&key](const Factor& factor) {
    return std::ranges::any_of(factor.targets, [&key](const Target& target) { return target.key == key; });
  };
  return first.stated.contains(key) || std::ranges::any_of(study.factors, moves);
}

/// Of the engine there is a value where its keys are stated.
void append_oil(const Study& study, const cycle::Case& first, StudyValues& values) {
  for (const cycle::OilLossQuantity& quantity : cycle::oil_loss_quantities()) {
    if (quantity.requires_key == nullptr || is_stated(quantity.requires_key, study, first)) {
      values.quantities.push_back(quantity);
    }
  }
  values.main.push_back(cycle::oil_loss_quantities().front().name);
}

}  // namespace

const std::vector<RingValue>& ring_values() {
  using enum RingValue::Rails;
  static const std::vector<RingValue> values = {{"fmep", kSum},
                                                {"mean_power_loss", kSum},
                                                {"mean_boundary_power", kSum},
                                                {"mean_viscous_power", kSum},
                                                {"archard_wear_load", kSum},
                                                {"min_film_thickness", kMin},
                                                {"min_lambda_ratio", kMin},
                                                {"boundary_regime_cycle_share", kMax},
                                                {"full_film_cycle_share", kMin},
                                                {"boundary_regime_energy_share", kMax},
                                                {"full_film_energy_share", kMin},
                                                {"peak_film_pressure", kMax}};
  return values;
}

double together(RingValue::Rails rails, double a, double b) {
  if (rails == RingValue::Rails::kSum) return a + b;
  return rails == RingValue::Rails::kMin ? std::min(a, b) : std::max(a, b);
}

std::string ring_value_name(std::size_t ring, const std::string& name) {
  return "ring_" + std::to_string(ring) + "_" + name;
}

std::string region_value_name(const std::string& region, const std::string& name) {
  std::string all = region + "_" + name;
  std::replace(all.begin(), all.end(), ' ', '_');
  return all;
}

std::optional<std::size_t> StudyValues::index(const std::string& name) const {
  const Quantity* found = find_by_name(quantities, name);
  return found ? std::optional(static_cast<std::size_t>(found - quantities.data())) : std::nullopt;
}

bool is_one_film(const Study& study, const cycle::Case& base) {
  return study.compute == Compute::kFilms && !base.is_pack() && !base.gas_path.is_computed() && !base.follows_oil();
}

StudyValues study_values(const Study& study, const cycle::Case& base) {
  StudyValues values;
  const bool has_films = study.compute == Compute::kFilms;
  if (has_films && base.is_pack()) {
    append_pack(base.rings.size(), values);
  } else if (has_films) {
    values.has_cycle = true;
    values.main = kMainOfCycle;
    const auto& all = cycle::cycle_quantities();
    values.quantities.assign(all.begin(), all.end());
  }
  if (!has_films || base.gas_path.is_computed()) append_gas(base, values);
  const cycle::Case& first = base.is_pack() ? base.rings.front() : base;
  if (has_films && first.follows_oil()) append_oil(study, first, values);
  return values;
}

}  // namespace ringfilm::study
