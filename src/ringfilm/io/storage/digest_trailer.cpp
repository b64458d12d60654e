#include "ringfilm/io/storage/digest_trailer.hpp"

#include <algorithm>

#include "ringfilm/base/error.hpp"
#include "ringfilm/io/storage/digest.hpp"

namespace ringfilm::io {
namespace {

constexpr std::string_view kTrailerStart = "\nringfilm sha256 ";

}  // namespace

std::string digest_trailer(std::string_view digits) { return std::string(kTrailerStart) + std::string(digits) + "\n"; }

bool begins_as_netcdf(std::string_view bytes) {
  constexpr std::string_view kClassicVersions = "\x01\x02\x05";
  const bool is_classic =
      bytes.starts_with("CDF") && bytes.size() > 3 && kClassicVersions.find(bytes[3]) != std::string_view::npos;
  return is_classic || bytes.starts_with("\x89HDF\r\n\x1a\n");
}

bool has_digest_trailer(std::string_view bytes) {
  const std::string_view trailer = bytes.substr(bytes.size() - std::min(bytes.size(), kDigestTrailerSize));
  return trailer.starts_with(kTrailerStart) && trailer.ends_with('\n');
}

std::string_view content_before_trailer(const std::string& name, std::string_view bytes) {
  const std::size_t size = bytes.size() < kDigestTrailerSize ? 0 : bytes.size() - kDigestTrailerSize;
  const std::string_view content = bytes.substr(0, size), trailer = bytes.substr(size);
  if (!has_digest_trailer(bytes)) {
    throw InputError(name + ": the file does not end with the SHA-256 digest that ringfilm writes",
                     "name a result as ringfilm wrote it: another program made or changed this file, it is cut off or "
                     "damaged, or an older ringfilm wrote it; for a result, run its case again");
  }
  const std::string computed = sha256(content);
  const std::string_view stored = trailer.substr(kTrailerStart.size(), computed.size());
  if (stored != computed) {
    const bool is_digest = stored.find_first_not_of("0123456789abcdef") == std::string_view::npos;
    throw InputError(
        name + ": the bytes of the file do not have the SHA-256 digest at its end: " + computed + " in place of " +
            (is_digest ? std::string(stored) : "a text that is not a digest"),  // which may not be UTF-8
        "the file is damaged or was changed by another program: take an intact copy, or run its case again");
  }
  return content;
}

}  // namespace ringfilm::io
