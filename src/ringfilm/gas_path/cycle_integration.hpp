#pragma once
#include <string>
#include <vector>

#include "ringfilm/gas_path/pack_system.hpp"
#include "ringfilm/gas_path/radau.hpp"
#include "ringfilm/gas_path/result.hpp"
#include "ringfilm/gas_path/scalar_transport.hpp"

namespace ringfilm::gas_path {

/// Integrates gas and rings over a cycle: from degree to degree of crank angle with steps that the error controls,
/// changes of flank contact located.
class CycleIntegration {
 public:
  /// Where a cycle begins: at the end of the intake stroke, where no ring moves [degree].
  static constexpr double kBeginDeg = 540;

  CycleIntegration(const Network& network, PackState begin);

  /// Steps that a cycle may take, those that are rejected included. Packs as in engines take some thousand. Among 1,200
  /// random ones whose motion repeats, the hardest takes 26,000: a light ring that bounces on little gas.
  static constexpr long kMaxSteps = 200'000;

  /// One cycle, from kBeginDeg to a cycle later. Throws ConvergenceError where no step is short enough, or where it
  /// takes more steps than `most_steps`.
  void integrate(long most_steps = kMaxSteps);

  long n_steps() const { return n_steps_; }  ///< made in the last cycle, with those that were rejected

  const PackState& state() const { return state_; }
  void set_pressures(const std::vector<double>& pressure) { state_.pressure = pressure; }  ///< [bar]

  /// All that the last cycle left; blow-by, defect and peaks of the regions are there, periodicity is not.
  GasPathResult result() const;

  /// Masses of the accepted steps of the last cycle; empty unless Pack::composition asks for them.
  const std::vector<FlowStep>& flow_steps() const { return flow_steps_; }

  /// Derivatives of the pressures at the end of the last cycle by those at its begin, row by row; without the changes
  /// that the rings' motion makes.
  const std::vector<double>& sensitivity() const { return sensitivity_; }

 private:
  /// A change of contact that ends a step early.
  struct Found {
    std::size_t ring;
    FlankEvent event;
    double share;  ///< share of the step at which the event is
  };

  void begin_cycle();
  void record_degree(int degree);
  void advance_to(double end_deg);
  double attempt(double h);
  [[noreturn]] void stop(const std::string& reason);
  void leave_flanks();
  std::vector<Found> first_events(double h);
  double event_value(std::size_t ring, FlankEvent event, double share, double h);
  double locate(std::size_t ring, FlankEvent event, double low, double high, double h);
  double shorten_to(std::vector<Found>& found, double h);
  void commit(double h);
  void close_balance(double h, std::vector<double>& moved);
  void record_flows(double h, FlowStep step, const std::vector<double>& net_before, const std::vector<double>& moved);
  void conclude(const Found& found);
  void update_peaks(double h);
  void reshape_sensitivity(const std::vector<std::size_t>& free_before);

  const Network& network_;
  PackSystem system_;
  RadauStep step_;
  PackState state_;
  double angle_ = kBeginDeg, next_step_ = 0;
  long n_steps_ = 0, most_steps_ = kMaxSteps;
  std::vector<double> y_, scale_, at_, pressure_, flow_, sensitivity_;
  // results of the cycle
  GasPathResult result_;
  std::vector<double> passed_;  ///< gross mass along each path [kg]
  std::vector<FlowStep> flow_steps_;
  double stored_before_ = 0;  ///< in the regions between chamber and crankcase [kg]
};

}  // namespace ringfilm::gas_path
