#include "fuzz_target.hpp"
#include "input_file.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/io/pad/pad_file.hpp"

/// The gap of a pad as CSV.
RINGFILM_FUZZ_TARGET(pad_gap) {
  using namespace ringfilm;
  static const io::Units units;
  const std::string path = fuzz::input_file(data, size, "gap.csv");
  try {
    io::read_gap({path, "gap.csv"}, units);
  } catch (const InputError& error) {
    describe(error.faults());
  }
  return 0;
}
