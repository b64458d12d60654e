#include "fuzz_target.hpp"
#include "input_file.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/io/pad/pad_file.hpp"

/// How the separation of a pad changes in time, as CSV.
RINGFILM_FUZZ_TARGET(pad_history) {
  using namespace ringfilm;
  static const io::Units units;
  const std::string path = fuzz::input_file(data, size, "history.csv");
  try {
    io::read_separation_history({path, "history.csv"}, units);
  } catch (const InputError& error) {
    describe(error.faults());
  }
  return 0;
}
