#include "bindings.hpp"

namespace ringfilm::python {
namespace {

void* refuse_use(std::size_t) {
  throw py::type_error(
      "this object was made by __new__ alone and is empty; call its class, or the function that returns such objects");
}

/// `__reduce__` of all classes, for every protocol. That of `object` aborts the interpreter for protocols below 2: it
/// calls the base class of pybind11, which cannot be constructed.
py::tuple reduce(const py::object& self) {
  const py::object type = py::type::of(self);
  if (!py::hasattr(type, "__setstate__")) {
    throw py::type_error("objects of " + py::cast<std::string>(type.attr("__module__")) + "." +
                         py::cast<std::string>(type.attr("__qualname__")) + " cannot be pickled or copied");
  }
  return py::make_tuple(py::module_::import("copyreg").attr("__newobj__"), py::make_tuple(type),
                        self.attr("__getstate__")());
}

void complete_class(const py::handle& type, py::detail::type_info& info) {
  info.operator_new = &refuse_use;
  type.attr("__reduce__") =
      py::cpp_function(&reduce, py::name("__reduce__"), py::is_method(type), "For pickle and copy.");
}

}  // namespace

// pybind11 gives an object of `Class.__new__(Class)` memory at its first use, without constructing anything in it, by
// the `operator_new` of its class, which it calls for nothing else. Unpickling constructs the object before it is used.
void complete_classes(const py::handle& module) {
  for (const auto& [name, value] : py::cast<py::dict>(module.attr("__dict__"))) {
    if (PyModule_Check(value.ptr()) != 0) {
      complete_classes(value);
    } else if (PyType_Check(value.ptr()) != 0) {
      auto* const info = py::detail::get_type_info(reinterpret_cast<PyTypeObject*>(value.ptr()));
      if (info != nullptr) complete_class(value, *info);
    }
  }
}

}  // namespace ringfilm::python
