#pragma once
#include "ringfilm/life/life_run.hpp"
#include "ringfilm/study/ensemble/batch.hpp"

namespace ringfilm::study {

/// What integrates the cycles of a life on threads: single ones as cycle::simulate does, many by simulate_cases.
/// @param progress called as each cycle ends: cycles that ended, cycles that were requested
life::CycleIntegrators cycle_integrators(const BatchOptions& options, const Progress& progress = {});

}  // namespace ringfilm::study
