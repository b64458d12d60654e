#pragma once
#include <gtest/gtest.h>
#include <openssl/evp.h>

#include <cstdlib>
#include <string>

#include "../io/scratch_folder.hpp"
#include "handmade_files.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/instrument/surface_file.hpp"

namespace ringfilm::instrument {

using io::ScratchFolder;

/// Building the units takes some ten milliseconds: once is enough.
inline const io::Units& units() {
  static const io::Units system;
  return system;
}

inline SurfaceFile read_bytes(const std::string& name, const std::string& bytes, const SurfaceOptions& options = {}) {
  const ScratchFolder folder;
  return read_surface_file(folder.write(name, bytes), options, units());
}

/// What the reader states no with; empty if it reads the file.
inline std::string refusal(const std::string& name, const std::string& bytes, const SurfaceOptions& options = {}) {
  try {
    read_bytes(name, bytes, options);
    return "";
  } catch (const InputError& error) {
    return describe(error.faults());
  }
}

inline std::string md5(const std::string& bytes) {
  unsigned char digest[16];
  unsigned int size = 0;
  EVP_Digest(bytes.data(), bytes.size(), digest, &size, EVP_md5(), nullptr);
  std::string text;
  for (const unsigned char byte : digest) {
    text += "0123456789ABCDEF"[byte >> 4];
    text += "0123456789ABCDEF"[byte & 15];
  }
  return text;
}

inline std::string x3p_archive(const handmade::X3p& parts) {
  std::vector<std::pair<std::string, std::string>> entries = {{"main.xml", parts.xml()}};
  const std::string sum = parts.checksum == "right" ? md5(parts.xml()) : parts.checksum;
  if (!sum.empty()) entries.push_back({"md5checksum.hex", sum + " *main.xml\n"});
  if (!parts.points.empty()) entries.push_back({"bindata/data.bin", parts.points});
  if (!parts.valid.empty()) entries.push_back({"bindata/valid.bin", parts.valid});
  return handmade::zip(entries);
}

/// Real instrument files, which are not part of the project: in instruments/ of the folder that RINGFILM_SHARED_FOLDER
/// names, else of shared/ beside the checkout.
inline std::string instrument_sample(const std::string& name) {
  const char* const named = std::getenv("RINGFILM_SHARED_FOLDER");
  const std::string folder = named != nullptr ? named : RINGFILM_SOURCE_FOLDER "/../shared";
  return folder + "/instruments/" + name;
}

}  // namespace ringfilm::instrument
