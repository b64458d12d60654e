#include "ringfilm/gas_path/scalar_transport.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

namespace ringfilm::gas_path {
namespace {

/// Share of a volume that air replaces in a cycle in the search for the periodic state: what nothing refills would be
/// indeterminate. A second solution from the first one removes it where something does.
constexpr double kReplaced = 1e-9;

/// Weight of the end of a step in what leaves a volume, so that one that a constant flow empties of a scalar follows
/// its exponential. @param x mass that leaves over that at the begin
double end_weight(double x) {
  constexpr double kSeries = 1e-3;
  if (x < kSeries) return 0.5 + x / 12;
  return 1 / -std::expm1(-x) - 1 / x;
}

/// A mass that passes from one region to another in a step.
struct Transfer {
  Eigen::Index from, to;  ///< regions
  double mass;            ///< [kg]
};

}  // namespace

void transport_step(const std::vector<Path>& paths, const FlowStep& step, const ReservoirShares& reservoirs,
                    ScalarTable& share, ScalarTable* forward, ScalarTable* back) {
  const Eigen::Index n = share.rows(), crankcase = n + 1;
  const auto is_volume = [&](Eigen::Index region) { return region > 0 && region < crankcase; };
  Eigen::VectorXd leaving = Eigen::VectorXd::Zero(n), weight(n);
  const auto transfers = [&](std::size_t k) {
    const auto from = static_cast<Eigen::Index>(paths[k].from), to = static_cast<Eigen::Index>(paths[k].to);
    return std::array{Transfer{from, to, step.forward[k]}, Transfer{to, from, step.back[k]}};
  };
  for (std::size_t k = 0; k < paths.size(); ++k) {
    for (const Transfer& one : transfers(k)) {
      if (is_volume(one.from)) leaving[one.from - 1] += one.mass;
    }
  }
  ScalarTable matrix = ScalarTable::Zero(n, n), known(n, share.cols());
  for (Eigen::Index i = 0; i < n; ++i) {
    const double before = step.mass_before[static_cast<std::size_t>(i)];
    weight[i] = end_weight(leaving[i] / before);
    matrix(i, i) = step.mass_after[static_cast<std::size_t>(i)] + weight[i] * leaving[i];
    known.row(i) = std::max(before - (1 - weight[i]) * leaving[i], 0.0) * share.row(i);
  }
  const Eigen::RowVectorXd of_chamber = (reservoirs.chamber_begin + reservoirs.chamber_end) / 2;
  for (std::size_t k = 0; k < paths.size(); ++k) {
    for (const Transfer& one : transfers(k)) {
      if (!is_volume(one.to)) continue;
      if (is_volume(one.from)) {
        matrix(one.to - 1, one.from - 1) -= weight[one.from - 1] * one.mass;
        known.row(one.to - 1) += (1 - weight[one.from - 1]) * one.mass * share.row(one.from - 1);
      } else {
        known.row(one.to - 1) += one.mass * (one.from == 0 ? of_chamber : reservoirs.crankcase);
      }
    }
  }
  const ScalarTable after = matrix.partialPivLu().solve(known);
  if (forward != nullptr && back != nullptr) {
    const auto carried = [&](const Transfer& one) -> Eigen::RowVectorXd {
      if (!is_volume(one.from)) return one.mass * (one.from == 0 ? of_chamber : reservoirs.crankcase);
      const double end = weight[one.from - 1];
      return one.mass * (end * after.row(one.from - 1) + (1 - end) * share.row(one.from - 1));
    };
    for (std::size_t k = 0; k < paths.size(); ++k) {
      const auto row = static_cast<Eigen::Index>(k);
      const auto both = transfers(k);
      forward->row(row) += carried(both[0]);
      back->row(row) += carried(both[1]);
    }
  }
  share = after;
}

namespace {

/// Runs a cycle from its begin, which the end replaces.
void run_cycle(const std::vector<Path>& paths, const std::vector<FlowStep>& steps, const ChamberShares& chamber,
               const Eigen::RowVectorXd& crankcase, ScalarTable& share, ScalarTable& forward, ScalarTable& back,
               const ScalarObserver& observer) {
  forward = back = ScalarTable::Zero(static_cast<Eigen::Index>(paths.size()), share.cols());
  if (steps.empty()) return;
  ReservoirShares reservoirs{{}, chamber(steps.front().begin_deg), crankcase};
  ScalarTable regions(share.rows() + 2, share.cols());
  for (const FlowStep& step : steps) {
    reservoirs.chamber_begin = reservoirs.chamber_end;
    reservoirs.chamber_end = chamber(step.end_deg);
    if (observer) {
      regions << reservoirs.chamber_begin, share, crankcase;
      observer(step, regions);
    }
    transport_step(paths, step, reservoirs, share, &forward, &back);
  }
}

/// Scalar mass that the paths bring into a region, and out of it. @param region of the reservoirs
Eigen::RowVectorXd entered(const std::vector<Path>& paths, std::size_t region, const ScalarTable& along,
                           const ScalarTable& against) {
  Eigen::RowVectorXd mass = Eigen::RowVectorXd::Zero(along.cols());
  for (std::size_t k = 0; k < paths.size(); ++k) {
    const auto row = static_cast<Eigen::Index>(k);
    if (paths[k].to == region) mass += along.row(row);
    if (paths[k].from == region) mass += against.row(row);
  }
  return mass;
}

/// Largest mass of a scalar that the balance of the cycle misses, over the gas that passes chamber and crankcase and is
/// stored.
double balance_defect(const std::vector<Path>& paths, const std::vector<FlowStep>& steps, const ScalarCycle& cycle) {
  const std::size_t crankcase = static_cast<std::size_t>(cycle.begin.rows()) + 1;
  Eigen::RowVectorXd missed = Eigen::RowVectorXd::Zero(cycle.begin.cols());
  double gas = 0;
  for (const std::size_t region : {std::size_t{0}, crankcase}) {
    const Eigen::RowVectorXd in = entered(paths, region, cycle.forward, cycle.back);
    const Eigen::RowVectorXd out = entered(paths, region, cycle.back, cycle.forward);
    missed += out - in;
    gas += in.sum() + out.sum();
  }
  for (Eigen::Index i = 0; i < cycle.begin.rows(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    missed -= steps.back().mass_after[at] * cycle.end.row(i) - steps.front().mass_before[at] * cycle.begin.row(i);
    gas += steps.front().mass_before[at];
  }
  return gas > 0 ? missed.cwiseAbs().maxCoeff() / gas : 0;
}

}  // namespace

ScalarCycle periodic_scalars(const std::vector<Path>& paths, const std::vector<FlowStep>& steps,
                             const ChamberShares& chamber, double air_mass, const Eigen::RowVectorXd& air,
                             const ScalarObserver& observer) {
  const Eigen::Index n_scalars = air.size();
  ScalarCycle cycle;
  cycle.crankcase = air;
  if (steps.empty()) return cycle;
  const auto n = static_cast<Eigen::Index>(steps.front().mass_before.size());
  // The end is linear in the begin, in the crankcase and in what the chamber gives: a column for each volume, one for
  // the crankcase, one for each scalar.
  ScalarTable map = ScalarTable::Zero(n, n + 1 + n_scalars), forward, back;
  map.leftCols(n).setIdentity();
  Eigen::RowVectorXd of_crankcase = Eigen::RowVectorXd::Zero(map.cols());
  of_crankcase[n] = 1;
  const auto source = [&](double angle) {
    Eigen::RowVectorXd of_chamber = Eigen::RowVectorXd::Zero(n + 1 + n_scalars);
    of_chamber.tail(n_scalars) = chamber(angle);
    return of_chamber;
  };
  run_cycle(paths, steps, source, of_crankcase, map, forward, back, {});
  const auto crankcase = static_cast<std::size_t>(n) + 1;
  const Eigen::RowVectorXd out_of_pack = entered(paths, crankcase, forward, back);
  double gas_in = air_mass;  // mass of gas into the crankcase
  for (std::size_t k = 0; k < paths.size(); ++k) {
    for (const FlowStep& step : steps) {
      if (paths[k].to == crankcase) gas_in += step.forward[k];
      if (paths[k].from == crankcase) gas_in += step.back[k];
    }
  }
  ScalarTable matrix = -map.leftCols(n + 1), known(n + 1, n_scalars), state(n + 1, n_scalars);
  matrix.conservativeResize(n + 1, Eigen::NoChange);
  matrix.row(n).setZero();
  known.topRows(n) = map.rightCols(n_scalars);
  known.row(n).setZero();
  if (gas_in > 0) {
    matrix.row(n) = -out_of_pack.head(n + 1) / gas_in;
    known.row(n) = (out_of_pack.tail(n_scalars) + air_mass * air) / gas_in;
    matrix(n, n) += 1;
  }
  matrix.diagonal().head(n).array() += 1;
  matrix.diagonal().array() += kReplaced;
  const auto factors = matrix.partialPivLu();
  state.rowwise() = air;
  for (int i = 0; i < 2; ++i) state = factors.solve(known + kReplaced * state).eval();
  cycle.begin = cycle.end = state.topRows(n);
  cycle.crankcase = state.row(n);
  run_cycle(paths, steps, chamber, cycle.crankcase, cycle.end, cycle.forward, cycle.back, observer);
  cycle.defect = balance_defect(paths, steps, cycle);
  return cycle;
}

}  // namespace ringfilm::gas_path
