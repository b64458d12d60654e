#pragma once
#include "bindings.hpp"
#include "case_object.hpp"

namespace ringfilm::python {

/// Runs a case without the interpreter lock; looks for Ctrl-C and tells `progress` now and then.
py::object run_case(CaseObject& self, const py::object& progress);

}  // namespace ringfilm::python
