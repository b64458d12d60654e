#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "fuzz_target.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/instrument/formats/sdf_file.hpp"

/// An SDF, text or binary. Every channel that passes is read.
RINGFILM_FUZZ_TARGET(sdf) {
  using namespace ringfilm;
  const std::string path = "a.sdf";
  const auto bytes = std::make_shared<const std::string>(reinterpret_cast<const char*>(data), size);
  try {
    const instrument::InstrumentFile file = instrument::read_sdf(path, bytes);
    for (std::size_t i = 0; i < file.channels.size() && i < 3; ++i) file.values(i);
  } catch (const InputError& error) {
    describe(error.faults());
  }
  return 0;
}
