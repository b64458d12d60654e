#include "arguments.hpp"
#include "errors.hpp"
#include "interpreter.hpp"
#include "ringfilm/io/life/face_comparison.hpp"
#include "ringfilm/io/life/life_output.hpp"
#include "ringfilm/study/ensemble/cycle_integrators.hpp"

namespace ringfilm::python {
namespace {

py::object read_json(const std::string& text) { return py::module_::import("json").attr("loads")(text); }

py::object run_life(const std::string& path, int threads) {
  io::LifeDocument document{io::read_life(path), {}, io::this_run()};
  Interruptible all;
  study::BatchOptions options;
  options.threads = threads;
  options.pulse = [&all] { all.pulse(); };
  all.run([&] { document.result = life::run_life(document.file.life, study::cycle_integrators(options)); });
  return read_json(io::life_json(document));
}

py::object compare_faces(const std::vector<std::string>& paths) {
  return read_json(io::face_comparison_json(io::read_face_comparison(paths)));
}

}  // namespace

void bind_life(py::module_& module) {
  module.def("run_life", &run_life, py::arg("path"), py::kw_only(), py::arg("threads") = 0,
             R"(Friction, oil and film of a ring over its running hours, from a life's file.

Returns what `ringfilm life --json` prints as a dict: a list `states` with a dict for each reported running time, SI,
running times in hours. Ctrl-C ends the run with KeyboardInterrupt. Throws InputError for a file that is not a life and
ConvergenceError for a cycle without a solution. threads: 0 for as many as the machine runs at once.)");
  module.def("compare_faces", &compare_faces, py::arg("paths"),
             R"(Lower bounds of the wear between the faces of cases, in the order of their running hours.

Returns what `ringfilm life faces --json` prints as a dict, SI.)");
}

}  // namespace ringfilm::python
