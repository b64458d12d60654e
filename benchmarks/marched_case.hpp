#pragma once
#include <string>

#include "ringfilm/io/case_file.hpp"

namespace ringfilm {

/// The cycle that the benchmarks of time measure: the paper's new ring, fixed steps of 1 degree.
inline cycle::Case case_to_march(int cells, cycle::Cavitation cavitation) {
  auto c = io::read_case(std::string(RINGFILM_SOURCE_FOLDER) + "/cases/styles2014/new.toml");
  c.solver.cells = cells;
  c.solver.crank_step_deg = 1;
  c.solver.crank_step_control = cycle::StepControl::kFixed;
  c.film.cavitation = cavitation;
  c.output.fields = cycle::FieldsWanted::kNone;
  return c;
}

}  // namespace ringfilm
