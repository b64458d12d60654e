#include "ringfilm/run/inverse/case_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "ringfilm/base/find_by_name.hpp"
#include "ringfilm/cycle/pack/gas_quantities.hpp"
#include "ringfilm/cycle/setup/kinematics.hpp"
#include "ringfilm/io/result/result_document.hpp"
#include "ringfilm/study/design/kept_curves.hpp"
#include "ringfilm/study/design/study_values.hpp"

namespace ringfilm::run {
namespace {

using cycle::Quantity;

/// Steps of crank angle over which curves are kept: the first one that the integration divides [degree].
constexpr double kCurveSteps[] = {0.5, 1, 2, 4, 5, 10};
/// The step where an accuracy chooses those of the integration [degree].
constexpr double kStepWithAccuracy = 2;

std::string oil_name(const std::string& part) { return "oil_consumption_" + part; }

/// Parts of the oil consumption, by cycle::OilLoss::name, with their units.
const std::vector<Quantity>& oil_quantities() {
  static const std::vector<Quantity> all = [] {
    std::vector<Quantity> quantities;
    for (const char* part : {"evaporation", "scraped_up", "carried_by_gas", "thrown_off", cycle::kTotalOilLoss}) {
      quantities.push_back({oil_name(part), "kg/s", "g/h", "oil consumption, " + std::string(part), "", ""});
    }
    quantities.push_back({oil_name(cycle::kEngineOilLoss), "kg/s", "g/h", "oil consumption of the engine", "", ""});
    quantities.push_back(
        {oil_name(cycle::kSpecificOilLoss), "kg/J", "g/(kW h)", "oil consumption over brake power", "", ""});
    quantities.push_back({oil_name(cycle::kFuelShareOfOil), "1", "1", "oil consumption over fuel", "", ""});
    return quantities;
  }();
  return all;
}

bool is_of_gas(const cycle::Case& c) { return c.purpose == cycle::CasePurpose::kGasPath; }

study::Study study_of(const cycle::Case& c) {
  study::Study study;
  study.compute = is_of_gas(c) ? study::Compute::kGas : study::Compute::kFilms;
  study.bases.push_back({"case", c});
  return study;
}

/// Of a pack what is lowest or highest of all rings, and does not add up.
std::vector<study::RingValue> extremes_of_rings() {
  std::vector<study::RingValue> extremes;
  for (const study::RingValue& one : study::ring_values()) {
    const bool adds_up = find_by_name(cycle::summed_quantities(), one.name) != nullptr;
    if (!adds_up && one.rails != study::RingValue::Rails::kSum) extremes.push_back(one);
  }
  return extremes;
}

template <class Quantities>
void append(const Quantities& quantities, std::vector<Quantity>& all) {
  all.insert(all.end(), quantities.begin(), quantities.end());
}

template <class Quantities, class Record>
void put(const Quantities& quantities, const Record& record, CaseNumbers& numbers) {
  for (const auto& quantity : quantities) numbers.values[quantity.name] = record.*quantity.value;
}

void put_oil(const std::vector<cycle::OilLoss>& losses, CaseNumbers& numbers) {
  for (const cycle::OilLoss& loss : losses) numbers.values[oil_name(loss.name)] = loss.value;
}

void put_gas(const io::PackGas& gas, CaseNumbers& numbers) {
  for (const auto& quantity : cycle::gas_sum_quantities()) {
    if (const auto value = cycle::number_of(quantity, gas.sums)) numbers.values[quantity.name] = *value;
  }
  for (const gas_path::RegionValues& region : gas.regions) {
    numbers.values[study::region_value_name(region.name, "peak_pressure")] = region.peak_pressure;
    numbers.values[study::region_value_name(region.name, "mean_pressure")] = region.mean_pressure;
  }
  for (std::size_t ring = 0; ring < gas.motion.size(); ++ring) {
    for (const cycle::GasRingQuantity& quantity : cycle::gas_ring_quantities()) {
      const auto value = cycle::number_of(quantity, gas.motion[ring]);
      const auto number = ring < gas.rings.size() ? static_cast<std::size_t>(gas.rings[ring].number) : ring + 1;
      if (value) numbers.values[study::ring_value_name(number, quantity.name)] = *value;
    }
  }
}

double ring_value(const cycle::CycleResult& result, const char* name) {
  return result.values.*cycle::cycle_quantities()[*cycle::cycle_quantity_index(name)].value;
}

void put_rings(const io::ResultDocument& pack, CaseNumbers& numbers) {
  const std::vector<std::size_t> ring = io::ring_numbers(pack);
  put(cycle::summed_quantities(), pack.result.values, numbers);
  const auto put_together = [&](const std::string& name, const study::RingValue& one, double here, bool is_first) {
    double& value = numbers.values[name];
    value = is_first ? here : study::together(one.rails, value, here);
  };
  for (std::size_t i = 0; i < pack.rings.size(); ++i) {
    const bool is_next_rail = i > 0 && ring[i] == ring[i - 1];
    for (const study::RingValue& one : study::ring_values()) {
      put_together(study::ring_value_name(ring[i], one.name), one, ring_value(pack.rings[i].result, one.name),
                   !is_next_rail);
    }
    for (const study::RingValue& one : extremes_of_rings()) {
      put_together(one.name, one, ring_value(pack.rings[i].result, one.name), i == 0);
    }
  }
  if (pack.gas) put_gas(*pack.gas, numbers);
}

/// The order of samples, which begin at firing TDC, from -360 degree on.
std::vector<std::size_t> rising_order(std::vector<double>& angles) {
  for (double& angle : angles) angle -= angle >= cycle::kCycleDeg / 2 ? cycle::kCycleDeg : 0;
  std::vector<std::size_t> order(angles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return angles[a] < angles[b]; });
  std::sort(angles.begin(), angles.end());
  return order;
}

template <class Quantities, class Samples>
void put_curve(const Quantities& quantities, const Samples& samples, const std::string& name,
               const std::vector<std::size_t>& order, CaseNumbers& numbers) {
  const auto* quantity = find_by_name(quantities, name);
  if (quantity == nullptr || samples.empty()) return;
  std::vector<double>& curve = numbers.curves[name];
  for (const std::size_t i : order) curve.push_back(samples[i].*quantity->value);
}

void put_curves(const cycle::CycleResult& result, const std::vector<std::string>& names, CaseNumbers& numbers) {
  for (const cycle::Sample& sample : result.samples) numbers.crank_angle_deg.push_back(sample.crank_angle_deg);
  const std::vector<std::size_t> order = rising_order(numbers.crank_angle_deg);
  for (const std::string& name : names) {
    put_curve(cycle::curve_quantities(), result.samples, name, order, numbers);
    put_curve(cycle::unrolled_quantities(), result.unrolled_samples, name, order, numbers);
  }
}

/// The curves of a pack that a study keeps under these names, or of all quantities for none.
study::Study with_curves(const cycle::Case& c, const std::vector<std::string>& quantities) {
  study::Study study = study_of(c);
  study.keep.curves = study::Curves::kAll;
  study.keep.quantities = quantities;
  study.keep.crank_step_deg = c.output.crank_angle_step_deg;
  return study;
}

/// All curves that rings of a pack have.
std::vector<std::string> pack_curves() {
  return {"total_friction", "friction_on_liner",  "boundary_friction",  "viscous_friction",
          "power_loss",     "applied_load",       "hydrodynamic_load",  "asperity_load",
          "lambda_ratio",   "min_film_thickness", "peak_film_pressure", "archard_wear_load_rate"};
}

void put_pack_curves(const cycle::Case& c, const io::ResultDocument& pack, const std::vector<std::string>& names,
                     CaseNumbers& numbers) {
  const study::Study study = with_curves(c, pack_curves());
  std::vector<cycle::CycleResult> faces;
  for (const io::ResultDocument& ring : pack.rings) faces.push_back(ring.result);
  const std::vector<float> kept = study::kept_numbers_of_pack(study, faces, io::ring_numbers(pack));
  numbers.crank_angle_deg = study::kept_angles(study.keep);
  const std::size_t n = numbers.crank_angle_deg.size();
  const std::vector<study::KeptCurve> curves = study::kept_curves(study);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (std::find(names.begin(), names.end(), curves[i].quantity.name) == names.end()) continue;
    const auto first = kept.begin() + static_cast<std::ptrdiff_t>(i * n);
    numbers.curves[curves[i].quantity.name].assign(first, first + static_cast<std::ptrdiff_t>(n));
  }
}

CaseNumbers numbers_of(const cycle::Case& c, const io::ResultDocument& document,
                       const std::vector<std::string>& curves) {
  CaseNumbers numbers;
  put_oil(document.oil_losses, numbers);
  if (document.is_pack()) {
    put_rings(document, numbers);
    if (!curves.empty()) put_pack_curves(c, document, curves, numbers);
    return numbers;
  }
  put(cycle::cycle_quantities(), document.result.values, numbers);
  if (!document.result.unrolled.is_absent()) {
    put(cycle::unrolled_cycle_quantities(), document.result.unrolled_values, numbers);
  }
  if (!curves.empty()) put_curves(document.result, curves, numbers);
  return numbers;
}

CaseNumbers numbers_of(const io::PadDocument& document) {
  CaseNumbers numbers;
  put(pad::reported_quantities(document.result), document.result.samples.back(), numbers);
  return numbers;
}

}  // namespace

std::vector<Quantity> value_quantities(const cycle::Case& c) {
  std::vector<Quantity> all;
  if (c.problem == cycle::Problem::kPad) {
    append(pad::pad_quantities(), all);
    if (c.pad.width) append(pad::width_quantities(), all);
    return all;
  }
  if (c.is_pack() || is_of_gas(c)) {
    all = study::study_values(study_of(c), c).quantities;
    if (is_of_gas(c)) return all;
    for (const study::RingValue& one : extremes_of_rings()) {
      Quantity quantity = cycle::cycle_quantities()[*cycle::cycle_quantity_index(one.name)];
      quantity.long_name.insert(0, "all rings: ");
      all.push_back(std::move(quantity));
    }
  } else {
    append(cycle::cycle_quantities(), all);
    if (c.is_unrolled()) append(cycle::unrolled_cycle_quantities(), all);
  }
  append(oil_quantities(), all);
  return all;
}

std::vector<Quantity> curve_quantities(const cycle::Case& c) {
  std::vector<Quantity> all;
  if (c.problem != cycle::Problem::kCycle || is_of_gas(c)) return all;
  if (c.is_pack()) {
    for (const study::KeptCurve& curve : study::kept_curves(with_curves(c, pack_curves()))) {
      all.push_back(curve.quantity);
    }
    return all;
  }
  append(cycle::curve_quantities(), all);
  all.erase(all.begin());  // the crank angle, which is the axis
  if (c.is_unrolled()) append(cycle::unrolled_quantities(), all);
  return all;
}

void ask_for_curves(cycle::Case& c, const std::vector<std::string>& curves) {
  if (c.problem != cycle::Problem::kCycle || is_of_gas(c)) return;
  study::OutputSelection keep;
  if (!curves.empty()) {
    keep.curves = study::Curves::kAll;
    const cycle::Solver& solver = c.is_pack() ? c.rings.front().solver : c.solver;
    keep.crank_step_deg = kStepWithAccuracy;
    const auto is_divided = [&](double step) {
      return std::abs(std::remainder(step, solver.crank_step_deg)) < 1e-9 * step;
    };
    const auto* step = std::find_if(std::begin(kCurveSteps), std::end(kCurveSteps), is_divided);
    if (!solver.accuracy && step != std::end(kCurveSteps)) keep.crank_step_deg = *step;
  }
  study::ask_for_kept(keep, c);
}

CaseNumbers case_numbers(const cycle::Case& c, const std::vector<std::string>& curves, Observer* observer) {
  cycle::Case asked = c;
  ask_for_curves(asked, curves);
  Options options;
  options.threads = 1;
  options.describe = false;
  options.accuracy_estimate = false;
  Outcome outcome = run_case(asked, options, observer);
  if (outcome.stopped) throw *outcome.stopped;
  if (const auto* pad = std::get_if<io::PadDocument>(&outcome.result)) return numbers_of(*pad);
  if (const auto* gas = std::get_if<io::GasPathDocument>(&outcome.result)) {
    CaseNumbers numbers;
    put_gas(gas->gas, numbers);
    return numbers;
  }
  if (const auto* document = std::get_if<io::ResultDocument>(&outcome.result)) {
    return numbers_of(asked, *document, curves);
  }
  throw InputError("the static closure of a ring has no cycle", "name a case with an engine cycle, or a pad");
}

}  // namespace ringfilm::run
