#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "fuzz_target.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/instrument/formats/digital_surf_file.hpp"

/// A surface of Digital Surf. Every channel that passes is read.
RINGFILM_FUZZ_TARGET(digital_surf) {
  using namespace ringfilm;
  const std::string path = "a.sur";
  const auto bytes = std::make_shared<const std::string>(reinterpret_cast<const char*>(data), size);
  try {
    const instrument::InstrumentFile file = instrument::read_digital_surf(path, bytes);
    for (std::size_t i = 0; i < file.channels.size() && i < 3; ++i) file.values(i);
  } catch (const InputError& error) {
    describe(error.faults());
  }
  return 0;
}
