#pragma once
#include <string>

namespace ringfilm::app {

/// Do the two names lead to one file, existing or not?
bool is_same_file(const std::string& a, const std::string& b);

}  // namespace ringfilm::app
