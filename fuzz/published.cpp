#include "fuzz_target.hpp"
#include "input_file.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/io/verification/published_file.hpp"

/// Published values as TOML, to be compared with.
RINGFILM_FUZZ_TARGET(published) {
  using namespace ringfilm;
  static const io::Units units;
  const std::string path = fuzz::input_file(data, size, "published.toml");
  try {
    io::read_published(path, "new", units);
  } catch (const InputError& error) {
    describe(error.faults());
  }
  return 0;
}
