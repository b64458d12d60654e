#pragma once
#include <string>

#include "ringfilm/case/case.hpp"

namespace ringfilm::cycle {

/// What solver.accuracy stands for (docs/theory/film.md, "accuracy").
struct Resolution {
  int cells_by_gap;       ///< across the face
  int uniform_cells;      ///< as good as these
  double crank_step_deg;  ///< the longest [degree]
  double step_error;      ///< let through per step [-]
  double tolerance;       ///< tolerance of the iteration [-]
};

/// Cells and steps with which 95 of 100 values of a cycle were found within `accuracy` [%].
Resolution resolution_for(double accuracy);

/// The case with the cells and steps that its solver.accuracy stands for, steps no longer than those of its curves; as
/// it is where it states none. @param coarse lengths of the cells of 0.5 % and more; below they are uniform
Case with_accuracy(Case c, CellLengths coarse = CellLengths::kByGap);

/// Is it a key in place of which an accuracy has its own value?
bool is_chosen_by_accuracy(const std::string& key);

/// What a case with_accuracy is computed with, as a sentence.
std::string accuracy_text(const Case& c);

}  // namespace ringfilm::cycle
