#include <filesystem>

#include "input_file.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/io/verification_file.hpp"

/// The claims of a folder of verification, in fuzz/beside, whose README and cases they refer to.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace ringfilm;
  static const io::Units units;
  const std::filesystem::path path = fuzz::input_file(data, size, "reference.toml");
  try {
    io::read_verification(path.parent_path().string(), units);
  } catch (const InputError& error) {
    describe(error.faults());
  }
  return 0;
}
