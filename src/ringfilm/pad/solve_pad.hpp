#pragma once
#include "ringfilm/base/error.hpp"
#include "ringfilm/case/case.hpp"
#include "ringfilm/pad/pad_result.hpp"

/// Films of stated shape, without engine and ring (docs/theory/pad.md).
namespace ringfilm::pad {

/// The film could not be solved, or not to the end; `result` holds all up to the last good instant.
class StoppedPad : public ConvergenceError {
 public:
  /// What was solved goes with it.
  StoppedPad(const std::string& message, PadResult result_so_far)
      : ConvergenceError(message), result(std::move(result_so_far)) {}
  PadResult result;  ///< its `complete` is false
};

/// Receives the progress of the time integration; may be slow; what it throws ends the work.
class Observer {
 public:
  virtual ~Observer() = default;
  virtual void advanced(double time, double end_time) = 0;  ///< [s]
};

/// The pad problem of a checked case (Problem::kPad): a steady film at a stated separation or under a stated load, or
/// the integration in time through a history of separations, backward Euler from the steady film at its first one.
/// Same case, same bits. Throws StoppedPad.
PadResult solve_pad(const cycle::Case& c, Observer* observer = nullptr);

}  // namespace ringfilm::pad
