#pragma once
#include <string>
#include <vector>

#include "ringfilm/case/case.hpp"

/// Studies and lives to start from (`ringfilm new study KIND`, `ringfilm new life`): files that run unchanged on a
/// case.
namespace ringfilm::io {

/// "map", "uncertainty" and "compare"; "operating-points" is start_points().
std::vector<std::string> start_study_kinds();

/// A study of a ring or a pack. @param case_path the case, as the study names it @param kind one of start_study_kinds()
std::string start_study(const std::string& kind, const cycle::Case& c, const std::string& case_path);

/// A face of the ring that wears. Throws InputError for a pack, whose rings have lives of their own.
/// @param case_path the case, as the life names it
std::string start_life(const cycle::Case& c, const std::string& case_path);

}  // namespace ringfilm::io
