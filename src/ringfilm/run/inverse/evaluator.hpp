#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "ringfilm/io/inverse/point_store.hpp"
#include "ringfilm/study/inverse/variable.hpp"

namespace ringfilm::run {

/// Values of the variables at one of the bases.
struct Trial {
  std::size_t base = 0;
  std::vector<double> values;  ///< [SI]
};

/// Computes cases with changed numbers, each once: points that are stored are not computed again. Same case, same
/// numbers, whatever the number of threads.
class Evaluator {
 public:
  /// @param curves names of the curves over crank angle that are kept  @param pulse called by every thread now and
  /// then; what it throws ends the work
  Evaluator(const study::VariedCases& cases, std::vector<std::string> curves, io::PointStore& store,
            std::function<void()> pulse);

  /// What comes of a trial; a case that breaks a rule or has no solution has its reason. May be called from several
  /// threads.
  io::StoredPoint operator()(const Trial& trial) const;

  /// What comes of several trials, on so many threads.
  std::vector<io::StoredPoint> all(const std::vector<Trial>& trials, int threads) const;

 private:
  const study::VariedCases& cases_;
  std::vector<std::string> curves_;
  io::PointStore& store_;
  std::function<void()> pulse_;
  std::string program_;
};

}  // namespace ringfilm::run
