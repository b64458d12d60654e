#pragma once
#include <string>
#include <string_view>

namespace ringfilm::io {

/// Bytes as text of letters, digits, + and /, in groups of four, the last one filled up with =. RFC 4648.
std::string base64(std::string_view bytes);

}  // namespace ringfilm::io
