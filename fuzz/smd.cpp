#include <string>

#include "fuzz_target.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/instrument/formats/smd_file.hpp"

/// A profile of ISO 5436-2. It is read where it passes.
RINGFILM_FUZZ_TARGET(smd) {
  using namespace ringfilm;
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  try {
    if (instrument::is_smd(bytes)) instrument::read_smd("a.smd", bytes).values(0);
  } catch (const InputError& error) {
    describe(error.faults());
  }
  return 0;
}
