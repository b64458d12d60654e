#include <memory>
#include <optional>
#include <string>

#include "arguments.hpp"
#include "bindings.hpp"
#include "interpreter.hpp"
#include "ringfilm/run/inverse/run_inverse.hpp"

namespace ringfilm::python {
namespace {

/// Runs work that takes a store and options, without the interpreter lock.
template <class Work>
py::object without_lock(const py::object& points, const py::object& threads, const Work& work) {
  run::InverseOptions options;
  options.threads = threads_of(threads);
  const std::optional<std::string> path = points.is_none() ? std::nullopt : std::optional(path_of("points", points));
  Interruptible all;
  options.pulse = [&all] { all.pulse(); };
  std::string json;
  all.run([&] {
    const auto store = path ? std::make_unique<io::PointStore>(*path) : std::make_unique<io::PointStore>();
    json = work(*store, options);
  });
  return from_json(json);
}

py::object fit(const Given<kinds::Path>& path, const py::object& threads, const py::object& points) {
  const std::string name = path_of("path", path.value);
  return without_lock(points, threads, [&](io::PointStore& store, const run::InverseOptions& options) {
    return io::fit_json(run::run_fit(run::read_fit(name), store, options));
  });
}

py::object optimise(const Given<kinds::Path>& path, const py::object& threads, const py::object& points) {
  const std::string name = path_of("path", path.value);
  return without_lock(points, threads, [&](io::PointStore& store, const run::InverseOptions& options) {
    return io::optimisation_json(run::run_optimisation(run::read_optimisation(name), store, options));
  });
}

}  // namespace

void bind_inverse(py::module_& module) {
  module.def("fit", &fit, py::arg("path"), py::kw_only(), py::arg("threads") = py::none(),
             py::arg("points") = py::none(),
             R"(Fits numbers of a case to measurements, from the file of a fit (docs/manual/fit.md).

Returns what `ringfilm fit --json` prints as a dict, SI: `parameters` with value, 95 % interval and whether they are
identified, `residual_rms`, `not_identified`, `predictions`, ... threads: None, or 1 to 1024; the numbers do not depend
on it. points: file that keeps every case that was computed, from which a later call continues; None: memory alone.
Ctrl-C ends the fit with KeyboardInterrupt. Raises InputError, ConvergenceError.)");
  module.def("optimise", &optimise, py::arg("path"), py::kw_only(), py::arg("threads") = py::none(),
             py::arg("points") = py::none(),
             R"(Searches the design of a case that meets targets, from the file of an optimisation
(docs/manual/optimise.md).

Returns what `ringfilm optimise --json` prints as a dict, SI: `best` with variables and quantities (None where no design
meets all constraints), `front`, `binding`, `violated`, ... threads, points: as for fit(). Ctrl-C ends the search with
KeyboardInterrupt. Raises InputError, ConvergenceError.)");
}

}  // namespace ringfilm::python
