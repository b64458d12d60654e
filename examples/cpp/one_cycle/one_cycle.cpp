// One engine cycle of one ring: a case file in; numbers, a result file and a page out.
//   one_cycle CASE.toml RESULT.nc PAGE.html
#include <cstdio>
#include <exception>
#include <fstream>

#include "ringfilm/ringfilm.hpp"

namespace {

void compute(const char* case_path, const char* result_path, const char* page_path) {
  using namespace ringfilm;
  const cycle::Case input = io::read_case(case_path, {{"operating.speed", "2000 rpm"}});
  const run::Outcome done = run::run_case(input);
  if (done.stopped) throw *done.stopped;  // the result so far would be there all the same
  const auto& document = std::get<io::ResultDocument>(done.result);
  const cycle::CycleResult& result = document.result;

  // Every quantity by its name, in SI, with the unit that people use beside it.
  for (const cycle::CycleQuantity& quantity : cycle::cycle_quantities()) {
    std::printf("%-40s %12.5g %s\n", quantity.name.c_str(), result.values.*quantity.value, quantity.unit.c_str());
  }
  // The same over crank angle: 0 degree is firing top dead centre.
  const cycle::Sample* thinnest = &result.samples.front();
  for (const cycle::Sample& sample : result.samples) {
    if (sample.min_film_thickness < thinnest->min_film_thickness) thinnest = &sample;
  }
  std::printf("the film is thinnest, %.3f um, at %g degree\n", thinnest->min_film_thickness * 1e6,
              thinnest->crank_angle_deg);
  for (const cycle::Note& note : result.notes) std::printf("note: %s\n", note.message.c_str());

  io::write_result(result_path, document);
  std::ofstream(page_path) << report::report_page({document}, {});
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: one_cycle CASE.toml RESULT.nc PAGE.html\n");
    return 2;
  }
  try {
    compute(argv[1], argv[2], argv[3]);
  } catch (const std::exception& error) {  // InputError contains file, line, rule and remedy
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
