#include "run.hpp"

#include "errors.hpp"
#include "interpreter.hpp"
#include "pad_object.hpp"
#include "result_object.hpp"
#include "ringfilm/cycle/simulate.hpp"
#include "ringfilm/pad/solve_pad.hpp"

namespace ringfilm::python {
namespace {

class CycleWatch : public cycle::Observer {
 public:
  explicit CycleWatch(const py::object& progress) : progress_(progress) {}
  void advanced(int cycle, double crank_angle_deg) override {
    interpreter_.visit([&] {
      if (!progress_.is_none()) progress_(cycle, crank_angle_deg);
    });
  }

 private:
  const py::object& progress_;
  Interpreter interpreter_;
};

class PadWatch : public pad::Observer {
 public:
  explicit PadWatch(const py::object& progress) : progress_(progress) {}
  void advanced(double time, double end_time) override {
    interpreter_.visit([&] {
      if (!progress_.is_none()) progress_(time, end_time);
    });
  }

 private:
  const py::object& progress_;
  Interpreter interpreter_;
};

py::object run_pad(const cycle::Case& input, const py::object& progress) {
  PadWatch watch(progress);
  try {
    pad::PadResult result;
    {
      const py::gil_scoped_release others_go_on;
      result = pad::solve_pad(input, &watch);
    }
    return py::cast(std::make_unique<PadObject>(input, std::move(result)));
  } catch (const pad::StoppedPad& stop) {
    raise_convergence(stop, py::cast(std::make_unique<PadObject>(input, stop.result)));
  }
}

}  // namespace

py::object run_case(CaseObject& self, const py::object& progress) {
  self.check();
  const cycle::Case input = self.value();  // another thread may change the case meanwhile
  if (input.problem == cycle::Problem::kPad) return run_pad(input, progress);
  CycleWatch watch(progress);
  try {
    cycle::CycleResult result;
    {
      const py::gil_scoped_release others_go_on;
      result = cycle::simulate(cycle::prepare(input), &watch);
    }
    return py::cast(std::make_unique<ResultObject>(input, std::move(result), io::this_run()));
  } catch (const cycle::StoppedCycle& stop) {
    cycle::CycleResult so_far = stop.result;
    so_far.complete = false;
    raise_convergence(stop, py::cast(std::make_unique<ResultObject>(input, std::move(so_far), io::this_run())));
  }
}

}  // namespace ringfilm::python
