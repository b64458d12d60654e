#include "fuzz_target.hpp"
#include "input_file.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/cycle/setup/setup.hpp"
#include "ringfilm/io/case/case_file.hpp"

/// A case file, with the files of fuzz/beside to refer to; what passes is set up to integrate and written out
/// again.
RINGFILM_FUZZ_TARGET(case) {
  using namespace ringfilm;
  static const io::Units units;
  const std::string path = fuzz::input_file(data, size, "case.toml");
  try {
    const cycle::Case c = io::read_case(path, {}, units);
    io::resolved_case(c);
    cycle::prepare(c);
  } catch (const InputError& error) {
    describe(error.faults());
  }
  return 0;
}
