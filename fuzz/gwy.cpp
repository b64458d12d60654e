#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "fuzz_target.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/instrument/formats/gwy_file.hpp"

/// A file of Gwyddion, as its program hands it over. Every channel that passes is read.
RINGFILM_FUZZ_TARGET(gwy) {
  using namespace ringfilm;
  const std::string path = "a.gwy";
  const auto bytes = std::make_shared<const std::string>(reinterpret_cast<const char*>(data), size);
  try {
    const instrument::InstrumentFile file = instrument::read_gwy(path, bytes);
    for (std::size_t i = 0; i < file.channels.size() && i < 3; ++i) file.values(i);
  } catch (const InputError& error) {
    describe(error.faults());
  }
  return 0;
}
