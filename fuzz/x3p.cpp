#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "fuzz_target.hpp"
#include "input_file.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/instrument/formats/x3p_file.hpp"

/// An X3P: the archive, its XML, its points. Every channel that passes is read.
RINGFILM_FUZZ_TARGET(x3p) {
  using namespace ringfilm;
  const std::string path = fuzz::input_file(data, size, "a.x3p");

  try {
    const instrument::InstrumentFile file = instrument::read_x3p(path);
    for (std::size_t i = 0; i < file.channels.size() && i < 3; ++i) file.values(i);
  } catch (const InputError& error) {
    describe(error.faults());
  }
  return 0;
}
