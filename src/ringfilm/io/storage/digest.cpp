#include "ringfilm/io/storage/digest.hpp"

#include <openssl/evp.h>

#include <array>
#include <fstream>
#include <stdexcept>

namespace ringfilm::io {

struct RunningDigest::State {
  EVP_MD_CTX* context = EVP_MD_CTX_new();
  ~State() { EVP_MD_CTX_free(context); }
};

RunningDigest::RunningDigest(Kind kind) : state_(std::make_unique<State>()) {
  const EVP_MD* const method = kind == Kind::kMd5 ? EVP_md5() : EVP_sha256();
  if (state_->context == nullptr || EVP_DigestInit_ex(state_->context, method, nullptr) != 1) {
    throw std::runtime_error("libcrypto lacks MD5 or SHA-256");
  }
}

RunningDigest::~RunningDigest() = default;

void RunningDigest::add(std::string_view bytes) {
  if (EVP_DigestUpdate(state_->context, bytes.data(), bytes.size()) != 1) {
    throw std::runtime_error("libcrypto failed in a digest");
  }
}

std::string RunningDigest::digits() {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int n_bytes = 0;
  if (EVP_DigestFinal_ex(state_->context, digest.data(), &n_bytes) != 1) {
    throw std::runtime_error("libcrypto failed in a digest");
  }
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  for (unsigned int i = 0; i < n_bytes; ++i) {
    text += kDigits[digest[i] >> 4];
    text += kDigits[digest[i] & 15];
  }
  return text;
}

std::string sha256(std::string_view bytes) {
  RunningDigest digest(RunningDigest::Kind::kSha256);
  digest.add(bytes);
  return digest.digits();
}

std::string file_sha256(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) return "";
  RunningDigest digest(RunningDigest::Kind::kSha256);
  std::string block(1 << 20, '\0');
  while (in.read(block.data(), static_cast<std::streamsize>(block.size())).gcount() > 0) {
    digest.add(std::string_view(block).substr(0, static_cast<std::size_t>(in.gcount())));
  }
  return digest.digits();
}

}  // namespace ringfilm::io
