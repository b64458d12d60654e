#include "run.hpp"

#include <memory>
#include <string>

#include "errors.hpp"
#include "interpreter.hpp"
#include "pad/pad_object.hpp"
#include "result_object.hpp"

namespace ringfilm::python {
namespace {

class Progress : public run::Observer {
 public:
  explicit Progress(const py::object& progress) : progress_(progress) {}
  void begins(const std::string&) override {}
  void others_ended(int, int) override {
    interpreter_.visit([] {});
  }
  void advanced(int cycle, double crank_angle_deg) override { report(cycle, crank_angle_deg); }
  void advanced(double time, double end_time) override { report(time, end_time); }

 private:
  template <class First>
  void report(First first, double second) {
    interpreter_.visit([&] {
      if (!progress_.is_none()) progress_(first, second);
    });
  }

  const py::object& progress_;
  Interpreter interpreter_;
};

}  // namespace

py::object run_case(CaseObject& self, const py::object& progress, run::Options options) {
  self.check();
  const cycle::Case input = self.value();  // another thread may change the case meanwhile
  Progress observer(progress);
  options.describe = options.ledger || options.error_estimate || input.solver.accuracy.has_value();
  run::Outcome done;
  {
    const py::gil_scoped_release others_go_on;
    done = run::run_case(input, options, &observer);
  }
  py::object result;
  if (input.problem == cycle::Problem::kPad) {
    result = py::cast(std::make_unique<PadObject>(std::get<io::PadDocument>(std::move(done.result))));
  } else {
    auto document = std::get<io::ResultDocument>(std::move(done.result));
    result = done.input ? py::cast(std::make_unique<ResultObject>(*std::move(done.input), std::move(document.result),
                                                                  std::move(document.provenance)))
                        : result_object(std::move(document));
  }
  if (done.stopped) raise_convergence(*done.stopped, result);
  return result;
}

}  // namespace ringfilm::python
