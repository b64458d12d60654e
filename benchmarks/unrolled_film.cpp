#include <sys/resource.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <string>
#include <vector>

#include "ringfilm/cycle/simulate.hpp"
#include "ringfilm/io/case/case_file.hpp"
#include "ringfilm/io/result/result_file.hpp"

/// What the film of the whole ring costs, cell by cell across and around, beside the film of its face on the same cells
/// across: processor time of whole cycles with fixed steps of one degree, from one run (docs/manual/performance.md).
/// usage: unrolled_film [--quick]
namespace ringfilm {
namespace {

constexpr double kGap = 0.3e-3;  // [m]

enum class Ring { kClosed, kRigid, kBends };

struct Size {
  int cells, cells_y;
  Ring ring;
};

struct Cost {
  double seconds;  ///< of processor time a cycle
  double iterations_a_step;
};

Cost cost_of(cycle::Case c) {
  const cycle::Setup setup = cycle::prepare(std::move(c));
  const std::clock_t start = std::clock();
  const cycle::CycleResult result = cycle::simulate(setup);
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  const auto steps = static_cast<double>(result.effort.crank_steps);
  return {seconds / result.effort.cycles_integrated, static_cast<double>(result.effort.newton_iterations) / steps};
}

cycle::Case new_ring(int cells) {
  auto c = io::read_case(std::string(RINGFILM_SOURCE_FOLDER) + "/cases/styles2014/new.toml");
  c.film.cavitation = cycle::Cavitation::kMassConserving;
  c.solver.crank_step_control = cycle::StepControl::kFixed;
  c.solver.crank_step_deg = 1;
  c.solver.cells = cells;
  return c;
}

/// In the bore that cases/distorted-bore/followed.toml has.
void bend(cycle::Case& c) {
  c.ring.conformity = cycle::Conformity::kBeam;
  c.ring.radial_thickness = 3.5e-3;
  c.liner.distortion = {{2, 15e-6, 0, {}}, {3, 5e-6, 0, {}}, {4, 2e-6, 0, {}}};
}

/// Largest memory that the process has held so far [MB].
double most_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

void print_table(const std::vector<Size>& sizes) {
  std::printf("Whole ring, new ring of styles2014, mass-conserving, fixed steps of 1 degree, processor time\n\n");
  std::printf(
      "| cells | cells_y | gap    | s a cycle | us a node and step | iterations a step | face film, ms a cycle |"
      " ring : face film x strips | MB so far |\n");
  std::printf(
      "|------:|--------:|:-------|----------:|-------------------:|------------------:|----------------------:|"
      "--------------------------:|----------:|\n");
  for (const Size& size : sizes) {
    cycle::Case whole = new_ring(size.cells);
    whole.film.dimension = cycle::FilmDimension::kUnrolled;
    whole.solver.cells_y = size.cells_y;
    if (size.ring != Ring::kClosed) whole.ring.end_gap = kGap;
    if (size.ring == Ring::kBends) bend(whole);
    const Cost face = cost_of(new_ring(size.cells));
    const Cost ring = cost_of(std::move(whole));
    const double strips = size.ring == Ring::kClosed ? size.cells_y : size.cells_y + 1;
    std::printf("| %5d | %7d | %-6s | %9.2f | %18.3f | %17.2f | %21.1f | %26.2f | %9.0f |\n", size.cells, size.cells_y,
                size.ring == Ring::kClosed  ? "none"
                : size.ring == Ring::kBends ? "bends"
                                            : "0.3 mm",
                ring.seconds, 1e6 * ring.seconds / (720 * (size.cells + 1) * strips), ring.iterations_a_step,
                1e3 * face.seconds, ring.seconds / (strips * face.seconds), most_memory());
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace ringfilm

int main(int argc, char** argv) {
  using ringfilm::print_table;
  using ringfilm::Ring;
  if (argc > 1 && std::strcmp(argv[1], "--quick") == 0) {
    print_table({{50, 60, Ring::kClosed},
                 {50, 60, Ring::kRigid},
                 {100, 60, Ring::kRigid},
                 {50, 120, Ring::kRigid},
                 {50, 120, Ring::kBends}});
  } else if (argc > 1) {
    std::fprintf(stderr, "usage: unrolled_film [--quick]\n");
    return 2;
  } else {
    print_table({{100, 60, Ring::kRigid},
                 {200, 60, Ring::kRigid},
                 {400, 60, Ring::kRigid},
                 {100, 120, Ring::kRigid},
                 {100, 240, Ring::kRigid},
                 {200, 180, Ring::kClosed},
                 {200, 180, Ring::kRigid},
                 {100, 180, Ring::kBends},
                 {200, 180, Ring::kBends},
                 {400, 180, Ring::kBends}});
  }
  return 0;
}
