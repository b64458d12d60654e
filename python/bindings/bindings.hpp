#pragma once
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>

/// The parts of the module `ringfilm._ringfilm`, each in the source of the same name.
namespace ringfilm::python {

namespace py = pybind11;

/// `__reduce_ex__` of classes with py::pickle: protocols below 2 know nothing of compiled classes, and 2 is taken for
/// them.
inline py::object reduce_ex(const py::object& self, int protocol) {
  return py::module_::import("builtins").attr("object").attr("__reduce_ex__")(self, std::max(protocol, 2));
}
inline constexpr const char* kReduceDoc = "For pickle and copy.";

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

/// Makes the use of an object that was never constructed a TypeError, for every class of the module and of its parts.
void refuse_unconstructed(const py::handle& module);

}  // namespace ringfilm::python
