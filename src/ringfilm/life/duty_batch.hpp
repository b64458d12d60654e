#pragma once
#include <functional>
#include <string>
#include <vector>

#include "ringfilm/life/life_run.hpp"
#include "ringfilm/life/pack_gas.hpp"

namespace ringfilm::life {

/// Receives the cycles of the operating points of a life, in their order.
using DutyTaker = std::function<void(std::vector<cycle::CycleResult>)>;

/// Which operating points a batch contains.
enum class Points {
  kAll,       ///< those that are only reported, too
  kOfTheDuty  ///< those with a share of the time
};

/// Cycles of the whole duty with one ring each, integrated together.
class DutyBatch {
 public:
  /// @param life kept by reference, as is the gas
  DutyBatch(const Life& life, PackGas& gas, Points points)
      : life_(life), gas_(gas), n_points_(points == Points::kAll ? life.points.size() : n_duty_points(life)) {}

  void add(const RingState& ring, const std::string& name, DutyTaker take);

  /// @returns how many cycles were integrated
  long integrate(const CycleIntegrator& integrator);

 private:
  const Life& life_;
  PackGas& gas_;
  std::size_t n_points_;
  std::vector<CycleRequest> requests_;
  std::vector<DutyTaker> takers_;
};

/// Shares of the cycles, those of the running time weighted with the speed, eq-life-duty.
std::vector<double> cycle_shares(const Life& life);

std::vector<LifeValues> values_of(const std::vector<cycle::CycleResult>& results);
/// eq-life-duty, of all points of the life or the first ones, those of the duty.
LifeValues of_duty(const Life& life, const std::vector<LifeValues>& points);

/// Puts face and values of a reported state into it, and the notes of its cycles into `notes`: one of each topic, as
/// the first cycle has it, with the number of cycles that carry it.
void take_duty(const Life& life, const std::vector<cycle::CycleResult>& results, LifeState& state,
               std::vector<cycle::Note>& notes);

/// What puts the values of the duty into `values`.
DutyTaker into(const Life& life, LifeValues& values);

/// Notes that the last measured state is held where later times are reported.
void append_held_note(const Life& life, LifeResult& result);

/// Adds the cycles with one part alone changed from the first state, for all later ones.
void add_parts(const Life& life, std::vector<LifeState>& states, DutyBatch& batch);

}  // namespace ringfilm::life
