#include <vector>

#include "bindings.hpp"
#include "run_program.hpp"

namespace ringfilm::python {

void bind_command_line(py::module_& module) {
  module.def(
      "_run_program",
      [](const std::vector<std::string>& words) {
        std::vector<const char*> pointers;
        for (const std::string& word : words) pointers.push_back(word.c_str());
        const py::gil_scoped_release others_go_on;
        return app::run_program(static_cast<int>(pointers.size()), pointers.data());
      },
      py::arg("words"), "The command line, its program's name first. Returns the exit code.");
}

}  // namespace ringfilm::python
