#pragma once
#include <map>
#include <vector>

#include "ringfilm/cycle/integration/time_integration.hpp"
#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/film/integrals/film2d_integrals.hpp"

namespace ringfilm::cycle {

/// What the ends of the gap do at one solved instant. @param whole the sample of that instant
UnrolledSample unrolled_sample(const Setup& setup, const TimeIntegration& integration, const Instant& instant,
                               const film::Film2dIntegrals& integrals, const Sample& whole);

/// What is left of the balance of a ring that bends: forces on all strips, each by its modulus, over its load [-].
double ring_imbalance(const film::Film2dProblem& problem, const film::Film2dInputs& inputs,
                      const film::FilmState& state, const std::vector<film::StripIntegrals>& strips);

/// Values of the cycle from samples at all base angles, equally spaced, and as many of the whole ring.
UnrolledValues unrolled_values(const std::vector<Sample>& whole, const std::vector<UnrolledSample>& samples);

/// Their replacement when the integration stopped: every value NaN.
UnrolledValues no_unrolled_values();

/// Keeps what only an unrolled film has, at the angles of a Recorder. An angle that is passed again replaces what was
/// kept.
class UnrolledRecorder {
 public:
  explicit UnrolledRecorder(const Setup& setup) : setup_(setup) {}

  void keep(const TimeIntegration& integration, const Instant& instant, const film::Film2dIntegrals& integrals,
            const Sample& whole);
  /// The fields of that instant, in full or by strips as the case asks.
  void keep_fields(const TimeIntegration& integration, const Instant& instant, const film::Film2dIntegrals& integrals);

  /// Adds what was kept at the angles of the result's samples. @param base at all base angles that were passed
  void add_to(CycleResult& result, const TimeIntegration& integration, const std::vector<Sample>& base) const;

 private:
  const Setup& setup_;
  std::map<double, UnrolledSample> samples_;  ///< by crank angle
  std::map<double, UnrolledFields> fields_;   ///< one angle each, without x, y and angle
};

}  // namespace ringfilm::cycle
