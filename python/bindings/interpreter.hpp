#pragma once
#include <chrono>

#include "bindings.hpp"

namespace ringfilm::python {

/// From work that goes on without the interpreter lock back to Python, now and then.
class Interpreter {
 public:
  /// Takes the lock at most every 20 ms: throws what a signal raised (Ctrl-C, on the main thread), then calls `tell`.
  template <class Tell>
  void visit(const Tell& tell) {
    if (is_visited_ && Clock::now() < next_) return;
    is_visited_ = true;
    const py::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    tell();
    next_ = Clock::now() + std::chrono::milliseconds(20);
  }

 private:
  using Clock = std::chrono::steady_clock;
  bool is_visited_ = false;
  Clock::time_point next_;
};

}  // namespace ringfilm::python
