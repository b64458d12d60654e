#pragma once
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

/// The parts of the module `ringfilm._ringfilm`, each in the source of the same name.
namespace ringfilm::python {

namespace py = pybind11;

void bind_errors(py::module_& module);
void bind_tables(py::module_& module);
void bind_case(py::module_& module);
void bind_result(py::module_& module);
void bind_gas_path(py::module_& module);
void bind_batch(py::module_& module);
void bind_pad(py::module_& module);
void bind_study(py::module_& module);
void bind_life(py::module_& module);
void bind_inverse(py::module_& module);
void bind_surface(py::module_& module);
/// Into the part `surface`.
void bind_contact_law(py::module_& part);
void bind_land_film(py::module_& part);
void bind_conform(py::module_& module);
void bind_face(py::module_& module);
void bind_lateral_force(py::module_& module);
void bind_laws(py::module_& module);
/// The closed contact laws, part of bind_laws.
void bind_summit_contact(py::module_& part);

/// What all classes of the module and of its parts have in common, once they are bound: the use of an object that was
/// never constructed is a TypeError, and so is pickling an object of a class without `__setstate__`.
void complete_classes(const py::handle& module);

}  // namespace ringfilm::python
