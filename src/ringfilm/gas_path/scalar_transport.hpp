#pragma once
#include <Eigen/Core>
#include <functional>
#include <vector>

#include "ringfilm/gas_path/network.hpp"

/// Passive scalars that the gas carries through the volumes of a pack (docs/theory/gas-composition.md).
namespace ringfilm::gas_path {

/// Masses of one accepted step of the gas path. The volumes between chamber and crankcase in their order.
struct FlowStep {
  double begin_deg = 0, end_deg = 0;            ///< crank angles [degree]
  std::vector<double> mass_before, mass_after;  ///< in each volume [kg]
  std::vector<double> forward, back;            ///< along each path, and against its direction, both positive [kg]
};

/// Rows: volumes or regions; columns: scalars.
using ScalarTable = Eigen::MatrixXd;

/// Mass shares of the scalars in chamber and crankcase: rows.
struct ReservoirShares {
  Eigen::RowVectorXd chamber_begin, chamber_end;  ///< at begin and end of a step [-]
  Eigen::RowVectorXd crankcase;                   ///< [-]
};

/// Carries scalars through a step, eq-scalar-step: conservative, and shares that begin between 0 and 1 remain there.
/// The scheme of a volume is fitted to its exponential, so that short steps are of second order.
/// @param share shares in the volumes at the begin, replaced by those at the end [-]
/// @param forward @param back mass of each scalar along each path; may be nullptr [kg]
void transport_step(const std::vector<Path>& paths, const FlowStep& step, const ReservoirShares& reservoirs,
                    ScalarTable& share, ScalarTable* forward = nullptr, ScalarTable* back = nullptr);

/// What a cycle of steps carries, and where it begins.
struct ScalarCycle {
  ScalarTable begin, end;        ///< shares in the volumes at begin and end of the cycle [-]
  Eigen::RowVectorXd crankcase;  ///< shares in the crankcase, constant over the cycle [-]
  ScalarTable forward, back;     ///< mass of each scalar along each path in the cycle [kg]
  /// Mass of a scalar that enters less that which leaves and remains, over the mass of gas that passes; the largest
  /// [-].
  double defect = 0;
};

/// Chamber shares at a crank angle.
using ChamberShares = std::function<Eigen::RowVectorXd(double angle_deg)>;
/// Receives the shares of all regions, the chamber first and the crankcase last, at the begin of a step.
using ScalarObserver = std::function<void(const FlowStep& step, const ScalarTable& regions)>;

/// The cycle that repeats itself: shares in the volumes at its end are those at its begin. The crankcase is a mixed
/// volume that the gas out of the pack and air refill, eq-crankcase-shares.
/// @param air_mass air into the crankcase in a cycle [kg] @param air its shares, those of volumes that nothing fills,
/// too
ScalarCycle periodic_scalars(const std::vector<Path>& paths, const std::vector<FlowStep>& steps,
                             const ChamberShares& chamber, double air_mass, const Eigen::RowVectorXd& air,
                             const ScalarObserver& observer = {});

}  // namespace ringfilm::gas_path
