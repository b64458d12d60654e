#include "fuzz_target.hpp"
#include "input_file.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/io/measurement/force_file.hpp"

/// Friction loops or their summary as CSV; what passes becomes a friction-load line.
RINGFILM_FUZZ_TARGET(force) {
  using namespace ringfilm;
  static const io::Units units;
  const std::string path = fuzz::input_file(data, size, "force.csv");
  try {
    const io::ForceFile file = io::read_force({path, "force.csv"}, units);
    const auto loads = file.loops.empty() ? file.loads : surface::friction_of_loads(file.loops, 0.1, 0);
    surface::friction_load_line(loads, surface::DeviationScale::kFromResiduals);
  } catch (const InputError& error) {
    describe(error.faults());
  }
  return 0;
}
