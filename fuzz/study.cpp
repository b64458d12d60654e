#include "fuzz_target.hpp"
#include "input_file.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/io/study/study_file.hpp"
#include "ringfilm/study/design/plan.hpp"
#include "ringfilm/study/design/scenario.hpp"

/// A study, with the files of fuzz/beside to refer to; of what passes some scenarios are made.
RINGFILM_FUZZ_TARGET(study) {
  using namespace ringfilm;
  const std::string path = fuzz::input_file(data, size, "study.toml");
  try {
    const study::Plan plan(io::read_study(path).study);
    plan.digest_text();
    study::check_scenarios(plan);
    plan.point(plan.size() - 1);
  } catch (const InputError& error) {
    describe(error.faults());
  }
  return 0;
}
