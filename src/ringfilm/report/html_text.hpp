#pragma once
#include <string>

namespace ringfilm::report {

/// A text as it may stand in an element or an attribute of HTML.
std::string html_text(const std::string& text);

}  // namespace ringfilm::report
