#pragma once
#include <string>
#include <string_view>

namespace ringfilm {

/// The text without blanks, tabs and line ends at both ends.
std::string trimmed(std::string_view text);

}  // namespace ringfilm
