#pragma once
#include "bindings.hpp"
#include "case_object.hpp"
#include "ringfilm/run/run.hpp"

namespace ringfilm::python {

/// Runs a case without the interpreter lock; looks for Ctrl-C and calls `progress` now and then.
py::object run_case(CaseObject& self, const py::object& progress, run::Options options);

}  // namespace ringfilm::python
