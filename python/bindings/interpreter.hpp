#pragma once
#include <atomic>
#include <chrono>
#include <functional>

#include "bindings.hpp"
#include "ringfilm/study/ensemble/threads.hpp"

namespace ringfilm::python {

/// Returns to Python now and then from work that continues without the interpreter lock.
class Interpreter {
 public:
  /// Takes the lock at most every 20 ms: throws what a signal raised (Ctrl-C, on the main thread), then calls `report`.
  template <class Report>
  void visit(const Report& report) {
    if (is_visited_ && Clock::now() < next_) return;
    is_visited_ = true;
    const py::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    report();
    next_ = Clock::now() + std::chrono::milliseconds(20);
  }

 private:
  using Clock = std::chrono::steady_clock;
  bool is_visited_ = false;
  Clock::time_point next_;
};

/// Work on threads of its own that Ctrl-C ends.
class Interruptible {
 public:
  /// Does the work without the interpreter lock. Python reports signals on its main thread alone, and there only when
  /// asked: so this thread asks, independently of the progress of the work.
  void run(const std::function<void()>& work) {
    const py::gil_scoped_release others_continue;
    study::run_while_polling(work, [this] {
      const py::gil_scoped_acquire lock;
      if (PyErr_CheckSignals() == 0) return;
      is_to_end_ = true;
      throw py::error_already_set();
    });
  }

  /// For the work to call now and then, from any thread: throws where it is to end.
  void pulse() const {
    if (is_to_end_) throw Interrupted{};
  }

 private:
  struct Interrupted {};
  std::atomic<bool> is_to_end_ = false;
};

}  // namespace ringfilm::python
