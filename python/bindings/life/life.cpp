#include <memory>

#include "arguments.hpp"
#include "errors.hpp"
#include "interpreter.hpp"
#include "ringfilm/io/life/face_comparison.hpp"
#include "ringfilm/io/life/life_output.hpp"
#include "ringfilm/report/life_page.hpp"
#include "ringfilm/study/ensemble/cycle_integrators.hpp"

namespace ringfilm::python {
namespace {

/// The record of a life, and a function of its web page.
py::tuple run_life(const Given<kinds::Path>& path, const Given<kinds::Integer>& given_threads) {
  const std::string name = path_of("path", path.value);
  const bool takes_all = given_threads.value.is_none() || integer_of("threads", given_threads.value) == 0;
  Interruptible all;
  study::BatchOptions options;
  options.threads = takes_all ? 0 : threads_of(given_threads.value);
  const auto document = std::make_shared<io::LifeDocument>(io::LifeDocument{io::read_life(name), {}, io::this_run()});
  options.pulse = [&all] { all.pulse(); };
  all.run([&] { document->result = life::run_life(document->file.life, study::cycle_integrators(options)); });
  return py::make_tuple(from_json(io::life_json(*document)),
                        py::cpp_function([document] { return report::life_page(*document); }));
}

py::object compare_faces(const Given<kinds::Paths>& paths) {
  return from_json(io::face_comparison_json(io::read_face_comparison(paths_of("paths", paths.value))));
}

}  // namespace

void bind_life(py::module_& module) {
  module.def("_run_life", &run_life, py::arg("path"), py::kw_only(), py::arg("threads") = 0,
             "Record and page for ringfilm.run_life: a dict, and a function of the text of the page.");
  module.def("compare_faces", &compare_faces, py::arg("paths"),
             R"(Lower bounds of the wear between the faces of cases, in the order of their running hours.

Returns what `ringfilm life faces --json` prints as a dict, SI.)");
}

}  // namespace ringfilm::python
