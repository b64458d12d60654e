#include "bindings.hpp"

namespace ringfilm::python {
namespace {

void* refuse_use(std::size_t) {
  throw py::type_error(
      "this object was made by __new__ alone and is empty; call its class, or the function that returns such objects");
}

}  // namespace

// pybind11 gives an object of `Class.__new__(Class)` memory at its first use, without constructing anything in it, by
// the `operator_new` of its class, which it calls for nothing else. Unpickling constructs the object before it is used.
void refuse_unconstructed(const py::handle& module) {
  for (const auto& [name, value] : py::cast<py::dict>(module.attr("__dict__"))) {
    if (PyModule_Check(value.ptr()) != 0) {
      refuse_unconstructed(value);
    } else if (PyType_Check(value.ptr()) != 0) {
      auto* const type = py::detail::get_type_info(reinterpret_cast<PyTypeObject*>(value.ptr()));
      if (type != nullptr) type->operator_new = &refuse_use;
    }
  }
}

}  // namespace ringfilm::python
