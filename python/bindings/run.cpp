#include "run.hpp"

#include <string>

#include "computation.hpp"
#include "errors.hpp"
#include "interpreter.hpp"
#include "pad/pad_object.hpp"
#include "result_object.hpp"
#include "ringfilm/cycle/pack/gas_through_films.hpp"
#include "ringfilm/cycle/simulate.hpp"
#include "ringfilm/pad/solve_pad.hpp"

namespace ringfilm::python {
namespace {

class CycleWatch : public app::ComputationWatch {
 public:
  explicit CycleWatch(const py::object& progress) : progress_(progress) {}
  void begins(const app::RunRequest&) override {}
  void others_ended(int, int) override {
    interpreter_.visit([] {});
  }
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

py::object run_pad(const cycle::Case& input, const py::object& progress, const RunExtras& extras) {
  if (extras.ledger || extras.error_estimate) {
    throw InputError(std::string(extras.ledger ? "ledger" : "error_estimate") + " is for rings",
                     "leave it out for a pad");
  }
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

/// With more to find out than the result alone.
py::object run_with_extras(const cycle::Case& input, CycleWatch& watch, const RunExtras& extras) {
  const app::RunRequest request{input, extras.ledger ? app::LedgerRequest::kComputed : app::LedgerRequest::kStatements,
                                extras.error_estimate ? app::ErrorRequest::kEstimated : app::ErrorRequest::kNone, ""};
  app::Computation done;
  {
    const py::gil_scoped_release others_go_on;
    done = std::move(app::computations({request}, {extras.threads}, watch).front());
  }
  py::object result = result_object(std::move(done.document));
  if (done.stopped) raise_convergence(*done.stopped, result);
  return result;
}

}  // namespace

py::object run_case(CaseObject& self, const py::object& progress, const RunExtras& extras) {
  self.check();
  const cycle::Case input = self.value();  // another thread may change the case meanwhile
  if (input.problem == cycle::Problem::kPad) return run_pad(input, progress, extras);
  CycleWatch watch(progress);
  if (extras.ledger || extras.error_estimate || input.solver.accuracy || input.is_pack())
    return run_with_extras(input, watch, extras);
  try {
    cycle::CycleResult result;
    {
      const py::gil_scoped_release others_go_on;
      result = cycle::simulate(cycle::prepare(cycle::solve_gas_through_films(input).input), &watch);
    }
    return py::cast(std::make_unique<ResultObject>(input, std::move(result), io::this_run()));
  } catch (const cycle::StoppedCycle& stop) {
    cycle::CycleResult so_far = stop.result;
    so_far.complete = false;
    raise_convergence(stop, py::cast(std::make_unique<ResultObject>(input, std::move(so_far), io::this_run())));
  }
}

}  // namespace ringfilm::python
