#pragma once
#include <string>
#include <vector>

#include "ringfilm/io/study_result.hpp"

namespace ringfilm::io {

/// How a study with `until` ended: how many points it took and how wide the interval then was for each base. Empty
/// without `until`.
std::vector<std::string> until_notes(const StudyRows& rows);

}  // namespace ringfilm::io
