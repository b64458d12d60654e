#pragma once
#include <map>
#include <optional>
#include <vector>

#include "ringfilm/cycle/integration/time_integration.hpp"
#include "ringfilm/cycle/integration/unrolled_sampling.hpp"
#include "ringfilm/cycle/result/result.hpp"

namespace ringfilm::cycle {

enum class Completeness { kComplete, kStopped };

/// The crank angles of the result, increasing, within [0, 720).
std::vector<double> requested_angles(const Output& output);

/// Keeps what the integration passes: all base angles for the cycle values, the angles asked for, the fields asked for.
/// An angle that is passed again replaces what was kept.
class Recorder : public StepObserver {
 public:
  explicit Recorder(const Setup& setup);

  /// Angles asked for inside the step are solved on the side.
  void before_step(TimeIntegration& integration, double from_deg, double to_deg) override;

  /// Keeps the instant if it is a base angle or one asked for.
  void after_step(const TimeIntegration& integration) override;

  /// What one cycle gave; `steps_integrated` base steps were needed.
  CycleResult result(const TimeIntegration& integration, double periodicity_error, int steps_integrated,
                     Completeness completeness) const;

 private:
  /// Returns the share of the asperity load from where the contact law is not trusted.
  double keep(const TimeIntegration& integration, const Instant& instant, Sample& slot);
  bool is_field_angle(double crank_angle_deg) const;

  const Setup& setup_;
  std::optional<UnrolledRecorder> unrolled_;  ///< recorder of an unrolled film, if there is one
  double step_deg_;
  std::vector<Sample> base_;                ///< at the base angles
  std::vector<std::vector<Sample>> steps_;  ///< at all steps on the way to each base angle, that included
  std::vector<Sample> on_the_way_;          ///< to the next base angle, so far
  /// Steps with an uncontrolled error, on the way to each base angle
  std::vector<std::vector<UncontrolledStep>> uncontrolled_;
  std::vector<UncontrolledStep> uncontrolled_on_the_way_;
  std::vector<bool> is_passed_;
  /// Share of the asperity load from where the contact law is not trusted, at each of base_
  std::vector<double> untrusted_share_;
  std::map<double, std::optional<Sample>> between_;  ///< requested angles that are not base angles
  std::vector<double> requested_deg_;                ///< crank angles of the requested samples, increasing
  std::vector<double> field_deg_;                    ///< crank angles of the requested fields, increasing
  std::map<double, FaceFields> fields_;              ///< one angle each
  double max_load_residual_ = 0;
  double largest_mass_defect_ = 0, largest_flow_ = 0;  ///< [kg/(m s)]
  long polynomial_steps_ = 0;
  double polynomial_share_ = 0;
};

}  // namespace ringfilm::cycle
