#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "fuzz_target.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/instrument/formats/height_table_file.hpp"

/// Heights as text, in the layout that the content speaks for. Every channel that passes is read.
RINGFILM_FUZZ_TARGET(height_table) {
  using namespace ringfilm;
  const std::string path = "a.csv";
  const auto bytes = std::make_shared<const std::string>(reinterpret_cast<const char*>(data), size);
  try {
    const instrument::InstrumentFile file =
        instrument::read_height_table(path, *bytes, instrument::TableLayout::kByContent);
    for (std::size_t i = 0; i < file.channels.size() && i < 3; ++i) file.values(i);
  } catch (const InputError& error) {
    describe(error.faults());
  }
  return 0;
}
