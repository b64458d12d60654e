#pragma once
#include "ringfilm/case/case.hpp"
#include "ringfilm/study/design/study_values.hpp"
#include "ringfilm/study/study_run.hpp"

namespace ringfilm::study {

/// A scenario that is more than one film at given pressures: a ring pack, a ring with its gas path, or the gas alone.
/// NaN for a piston land that this scenario does not have. Throws InputError and ConvergenceError where it has no
/// answer. @param values of its base
ScenarioRow pack_row(const cycle::Case& scenario, const Study& study, const StudyValues& values);

}  // namespace ringfilm::study
