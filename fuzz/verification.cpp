#include <filesystem>

#include "fuzz_target.hpp"
#include "input_file.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/io/verification/verification_file.hpp"

/// The claims of a folder of verification, in fuzz/beside, whose README and cases they refer to.
RINGFILM_FUZZ_TARGET(verification) {
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
