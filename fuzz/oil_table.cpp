#include "fuzz_target.hpp"
#include "input_file.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/io/data/oil_file.hpp"

/// Viscosity and density of an oil as CSV.
RINGFILM_FUZZ_TARGET(oil_table) {
  using namespace ringfilm;
  static const io::Units units;
  const std::string path = fuzz::input_file(data, size, "oil.csv");
  try {
    io::read_oil_table({path, "oil.csv"}, units);
  } catch (const InputError& error) {
    describe(error.faults());
  }
  return 0;
}
