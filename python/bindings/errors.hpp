#pragma once
#include "bindings.hpp"
#include "ringfilm/base/error.hpp"

namespace ringfilm::python {

/// Throws the Python exception of the refusal: the text as the program prints it, the faults one by one.
[[noreturn]] void raise_convergence(const ConvergenceError& error, const py::object& result);

/// The Python exception of a refusal, for who keeps it.
py::object input_error(const InputError& error);

}  // namespace ringfilm::python
