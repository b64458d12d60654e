#include <string_view>

#include "fuzz_target.hpp"
#include "input_file.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/io/pad/pad_file.hpp"

/// The gap of a pad over x and y, as CSV. NetCDF-4 is read by a library, whose faults are not ours to find.
RINGFILM_FUZZ_TARGET(pad_map) {
  using namespace ringfilm;
  static const io::Units units;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  if (bytes.substr(0, 4) == "\x89HDF") return 0;
  const std::string path = fuzz::input_file(data, size, "gap.csv");
  try {
    const io::GapFile gap = io::read_gap({path, "gap.csv"}, units);
    if (!gap.y.empty() && gap.height.size() != gap.x.size() * gap.y.size()) __builtin_trap();
  } catch (const InputError& error) {
    describe(error.faults());
  }
  return 0;
}
