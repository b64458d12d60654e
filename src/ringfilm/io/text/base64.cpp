#include "ringfilm/io/text/base64.hpp"

#include <openssl/evp.h>

#include <algorithm>

namespace ringfilm::io {

std::string base64(std::string_view bytes) {
  constexpr std::size_t kBlock = 3 << 20;                  // whole groups of three bytes; the library counts in int
  std::string text((bytes.size() + 2) / 3 * 4 + 1, '\0');  // the library ends each block with a zero
  std::size_t length = 0;
  for (std::size_t at = 0; at < bytes.size(); at += kBlock) {
    const std::string_view block = bytes.substr(at, std::min(kBlock, bytes.size() - at));
    length += static_cast<std::size_t>(EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data() + length),
                                                       reinterpret_cast<const unsigned char*>(block.data()),
                                                       static_cast<int>(block.size())));
  }
  text.resize(length);
  return text;
}

}  // namespace ringfilm::io
