#pragma once
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <string>
#include <utility>

/// The parts of the module `ringfilm._ringfilm`, each in the source of the same name.
namespace ringfilm::python {

namespace py = pybind11;

/// The name of a file from a str, bytes or path. Throws ValueError for one that no file can have.
inline std::string path_of(const py::object& path) {
  const auto name = py::cast<std::string>(py::module_::import("os").attr("fsencode")(path));
  if (name.find('\0') == std::string::npos) return name;
  throw py::value_error("the name of a file has a null byte in it");
}

/// Makes a class one for pickle and copy. Protocols below 2 know nothing of compiled classes: 2 is taken for them.
template <class Type, class GetState, class SetState>
void picklable(py::class_<Type>& type, GetState get, SetState set) {
  type.def(py::pickle(std::move(get), std::move(set)));
  type.def(
      "__reduce_ex__",
      [](const py::object& self, int protocol) {
        return py::module_::import("builtins").attr("object").attr("__reduce_ex__")(self, std::max(protocol, 2));
      },
      py::arg("protocol"), "For pickle and copy.");
}

void bind_errors(py::module_& module);
void bind_tables(py::module_& module);
void bind_case(py::module_& module);
void bind_result(py::module_& module);
void bind_batch(py::module_& module);
void bind_pad(py::module_& module);
void bind_study(py::module_& module);
void bind_surface(py::module_& module);
void bind_face(py::module_& module);
void bind_lateral_force(py::module_& module);
void bind_laws(py::module_& module);
void bind_command_line(py::module_& module);

}  // namespace ringfilm::python
