#pragma once
#include <string>

#include "ringfilm/io/study/study_result.hpp"

namespace ringfilm::io {

/// NetCDF-4 over the dimension scenario: base, factors, values of the cycle; and curves in full over (scenario,
/// crank_angle, ring), or their quantiles over (base_case, quantile, crank_angle, ring); docs/manual/study.md. Same
/// rows, same bytes, however they were split into files. Written block by block beside what curve_bands() takes: memory
/// does not grow with the number of scenarios but by a few bytes for each. Throws OutputError, before anything is
/// written where the disk might be too small for all of it.
void write_study_result(const std::string& path, const StudyRows& rows);

}  // namespace ringfilm::io
