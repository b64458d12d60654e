#include <string>

#include "fuzz_target.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/instrument/formats/trade_table_file.hpp"

/// Text with the head of a program: Zygo, Alicona, Keyence, Olympus, phase maps. Every channel that passes is read.
RINGFILM_FUZZ_TARGET(trade_table) {
  using namespace ringfilm;
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    const auto file = instrument::read_trade_table("a.txt", text);
    for (std::size_t i = 0; file && i < file->channels.size() && i < 3; ++i) file->values(i);
  } catch (const InputError& error) {
    describe(error.faults());
  }
  return 0;
}
