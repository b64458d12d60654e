#include "ringfilm/study/ensemble/assumed_inputs.hpp"

#include <algorithm>
#include <cmath>

#include "ringfilm/cycle/menisci_cycle.hpp"
#include "ringfilm/cycle/setup/setup.hpp"

namespace ringfilm::study {
namespace {

/// A coarse grid of a pack; finer ones change what its rings leave on the liner by less than inputs do.
constexpr int kCells = 100;
constexpr double kStepError = 3e-3;

void coarsen(cycle::Case& c) {
  c.output.fields = cycle::FieldOutput::kNone;
  c.output.field_angles_deg.clear();
  c.output.crank_angles_deg.clear();
  c.solver.accuracy.reset();
  if (c.problem == cycle::Problem::kCycle && !c.is_pack() && is_quick(c)) {
    c.solver.method = cycle::Method::kMenisci;
    return;
  }
  c.solver.method = cycle::Method::kCoupledNewton;
  c.solver.cells = std::min(c.solver.cells, kCells);
  c.solver.step_error = std::max(c.solver.step_error, kStepError);
}

}  // namespace

bool is_quick(const cycle::Case& c) {
  if (c.problem != cycle::Problem::kCycle || c.is_pack() || c.gas_path.is_computed()) return false;
  cycle::Case without_fields = c;
  without_fields.output.fields = cycle::FieldOutput::kNone;
  return !cycle::no_menisci_since(cycle::prepare(without_fields));
}

cycle::Case coarse_case(cycle::Case c) {
  coarsen(c);
  for (cycle::Case& ring : c.rings) coarsen(ring);
  return c;
}

void rank(std::vector<AssumedInput>& inputs) {
  std::stable_sort(inputs.begin(), inputs.end(), [](const AssumedInput& a, const AssumedInput& b) {
    if (a.solved != b.solved) return a.solved;
    return std::abs(a.fmep_change) > std::abs(b.fmep_change);
  });
}

}  // namespace ringfilm::study
