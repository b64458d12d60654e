#pragma once
#include <memory>
#include <string>
#include <string_view>

namespace ringfilm::io {

/// A digest that takes its bytes piece by piece.
class RunningDigest {
 public:
  enum class Kind { kMd5, kSha256 };

  explicit RunningDigest(Kind kind);
  ~RunningDigest();
  RunningDigest(const RunningDigest&) = delete;
  RunningDigest& operator=(const RunningDigest&) = delete;

  void add(std::string_view bytes);

  /// Lower-case hexadecimal digits; nothing can be added afterwards.
  std::string digits();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// SHA-256 of the bytes, as 64 lower-case hexadecimal digits.
std::string sha256(std::string_view bytes);

/// SHA-256 of a file, read piece by piece; empty if it cannot be read.
std::string file_sha256(const std::string& path);

}  // namespace ringfilm::io
