#include <vector>

#include "bindings.hpp"
#include "run_program.hpp"

namespace ringfilm::python {

void bind_command_line(py::module_& module) {
  module.def(
      "_run_program",
      [](const std::vector<std::string>& arguments) {
        std::vector<const char*> pointers;
        for (const std::string& argument : arguments) pointers.push_back(argument.c_str());
        const py::gil_scoped_release others_continue;
        return app::run_program(static_cast<int>(pointers.size()), pointers.data());
      },
      py::arg("arguments"), "The command line, its program's name first. Returns the exit code.");
}

}  // namespace ringfilm::python
