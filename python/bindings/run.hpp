#pragma once
#include "bindings.hpp"
#include "case_object.hpp"

namespace ringfilm::python {

/// What a run is to find out beside the result itself.
struct RunExtras {
  bool ledger = false;          ///< the other choice for every assumption that can be lifted
  bool error_estimate = false;  ///< other grids
  int threads = 0;              ///< for these; 0: as many as the machine runs at once
};

/// Runs a case without the interpreter lock; looks for Ctrl-C and calls `progress` now and then.
py::object run_case(CaseObject& self, const py::object& progress, const RunExtras& extras);

}  // namespace ringfilm::python
