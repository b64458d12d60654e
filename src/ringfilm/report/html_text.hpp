#pragma once
#include <string>

namespace ringfilm::report {

/// A text with the special characters of HTML escaped, for an element or an attribute.
std::string html_text(const std::string& text);

}  // namespace ringfilm::report
