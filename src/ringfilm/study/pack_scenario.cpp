#include "ringfilm/study/pack_scenario.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "ringfilm/cycle/cycle_values.hpp"
#include "ringfilm/cycle/pack/gas_quantities.hpp"
#include "ringfilm/cycle/pack/gas_through_films.hpp"
#include "ringfilm/cycle/pack/oil_consumption.hpp"
#include "ringfilm/cycle/pack/rails_of_pack.hpp"
#include "ringfilm/cycle/pack/simulate_pack.hpp"
#include "ringfilm/gas_path/solve_gas_path.hpp"
#include "ringfilm/study/design/kept_curves.hpp"

namespace ringfilm::study {
namespace {

using cycle::Case;
using cycle::CycleResult;

class Row {
 public:
  explicit Row(const StudyValues& values) : values_(values) {
    row_.values.assign(values.quantities.size(), std::numeric_limits<double>::quiet_NaN());
  }

  void put(const std::string& name, std::optional<double> value) {
    const auto index = values_.index(name);
    if (index && value) row_.values[*index] = *value;
  }

  void put_gas(const gas_path::GasPathResult& gas, double gas_constant) {
    const gas_path::GasSums sums = gas_path::gas_sums(gas, gas_constant);
    for (const auto& quantity : cycle::gas_sum_quantities()) put(quantity.name, cycle::number_of(quantity, sums));
    for (const gas_path::RegionValues& region : gas.regions) {
      put(region_value_name(region.name, "peak_pressure"), region.peak_pressure);
      put(region_value_name(region.name, "mean_pressure"), region.mean_pressure);
    }
    for (std::size_t ring = 0; ring < gas.motion.size(); ++ring) {
      for (const cycle::GasRingQuantity& quantity : cycle::gas_ring_quantities()) {
        put(ring_value_name(ring + 1, quantity.name), cycle::number_of(quantity, gas.motion[ring]));
      }
    }
  }

  void put_oil(const std::vector<cycle::OilLoss>& losses) {
    for (const cycle::OilLossQuantity& quantity : cycle::oil_loss_quantities()) {
      const auto loss = std::ranges::find(losses, quantity.loss, &cycle::OilLoss::name);
      if (loss != losses.end()) put(quantity.name, (*loss).*quantity.member);
    }
  }

  void put_curves(std::vector<float> curves) { row_.curves = std::move(curves); }

  void put_cycle(const CycleResult& result) {
    for (const auto& quantity : cycle::cycle_quantities()) put(quantity.name, result.values.*quantity.value);
    note(result.notes, "");
  }

  /// @param numbers of the rings to which the faces belong, from 1; in rising order
  void put_rings(const std::vector<CycleResult>& faces, const std::vector<std::size_t>& numbers) {
    cycle::CycleValues pack;
    for (const CycleResult& face : faces) cycle::add_ring(face.values, pack);
    for (const cycle::CycleQuantity& sum : cycle::summed_quantities()) put(sum.name, pack.*sum.value);
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const bool is_next_rail = i > 0 && numbers[i] == numbers[i - 1];
      for (const RingValue& one : ring_values()) {
        const std::string name = ring_value_name(numbers[i], one.name);
        const double here = value(faces[i], one.name);
        put(name, is_next_rail ? together(one.rails, row_.values[*values_.index(name)], here) : here);
      }
      note(faces[i].notes, "ring " + std::to_string(numbers[i]) + ": ");
    }
  }

  void note(std::vector<cycle::Note> notes, const std::string& prefix) {
    for (cycle::Note& note : notes) note.message.insert(0, prefix);
    add_topics(std::move(notes), row_);
  }

  ScenarioRow row() && { return std::move(row_); }

 private:
  static double value(const CycleResult& result, const char* name) {
    return result.values.*cycle::cycle_quantities()[*cycle::cycle_quantity_index(name)].value;
  }

  const StudyValues& values_;
  ScenarioRow row_;
};

/// The faces of a case whose pressures are known, from the chamber to the crankcase.
std::vector<CycleResult> films_of(const Case& c) {
  std::vector<CycleResult> faces;
  for (cycle::RingOutcome& outcome : cycle::simulate_rings(c)) {
    if (outcome.stop) throw ConvergenceError(outcome.stop->message, outcome.stop->crank_angle_deg);
    faces.push_back(std::move(outcome.result));
  }
  return faces;
}

/// The ring of the pack to which each face belongs, from 1.
std::vector<std::size_t> ring_numbers(const Case& pack, const Case& with_rails) {
  std::vector<std::size_t> numbers;
  for (std::size_t ring = 0; ring < pack.rings.size(); ++ring) {
    numbers.insert(numbers.end(), static_cast<std::size_t>(std::max(pack.rings[ring].ring.rails, 1)), ring + 1);
  }
  if (numbers.size() != with_rails.rings.size()) throw std::logic_error("a pack with other rails than its rings have");
  return numbers;
}

}  // namespace

ScenarioRow pack_row(const Case& scenario, const Study& study, const StudyValues& values) {
  Row row(values);
  if (study.compute == Compute::kGas) {
    const gas_path::Pack pack = cycle::gas_pack(scenario);
    const gas_path::GasPathResult gas = gas_path::solve_gas_path(pack, cycle::given_pressures(scenario));
    row.put_gas(gas, pack.gas.gas_constant);
    row.note(cycle::gas_path_notes(scenario, pack, gas), "");
    return std::move(row).row();
  }
  const Case faces = cycle::with_rails(scenario);
  const cycle::CaseWithGas found = cycle::solve_gas_through_films(faces);
  if (found.gas) row.put_gas(*found.gas, found.input.gas_path.gas_constant);
  const std::vector<CycleResult> films = films_of(found.input);
  std::vector<const CycleResult*> faces_down;
  for (const CycleResult& film : films) faces_down.push_back(&film);
  row.put_oil(cycle::oil_losses(found.input, faces_down, found.gas));
  if (scenario.is_pack()) {
    const std::vector<std::size_t> numbers = ring_numbers(scenario, faces);
    row.put_rings(films, numbers);
    row.put_curves(kept_numbers_of_pack(study, films, numbers));
  } else {
    row.put_cycle(films.front());
    row.put_curves(kept_numbers(study.keep, films.front().samples));
  }
  return std::move(row).row();
}

}  // namespace ringfilm::study
