#include "fuzz_target.hpp"
#include "input_file.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/io/verification/overlay_file.hpp"

/// Measured curves as CSV, to be laid over computed ones.
RINGFILM_FUZZ_TARGET(overlay) {
  using namespace ringfilm;
  static const io::Units units;
  const std::string path = fuzz::input_file(data, size, "overlay.csv");
  try {
    io::read_overlay(path, units);
  } catch (const InputError& error) {
    describe(error.faults());
  }
  return 0;
}
