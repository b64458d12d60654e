#include "ringfilm/io/digest.hpp"

#include <openssl/evp.h>

#include <array>
#include <stdexcept>

namespace ringfilm::io {

std::string sha256(std::string_view bytes) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int n_bytes = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &n_bytes, EVP_sha256(), nullptr) != 1) {
    throw std::runtime_error("libcrypto has no SHA-256");
  }
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  for (unsigned int i = 0; i < n_bytes; ++i) {
    text += kDigits[digest[i] >> 4];
    text += kDigits[digest[i] & 15];
  }
  return text;
}

}  // namespace ringfilm::io
