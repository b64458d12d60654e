#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <cstdio>
#include <string>

#include "ringfilm/surface/asperity/asperities.hpp"
#include "ringfilm/surface/asperity/scale.hpp"
#include "ringfilm/surface/asperity/summits.hpp"
#include "ringfilm/surface/synthetic/synthetic.hpp"
#include "ringfilm/surface/topography/filter.hpp"
#include "ringfilm/surface/topography/form.hpp"
#include "ringfilm/surface/topography/material_ratio.hpp"
#include "ringfilm/surface/topography/roughness.hpp"
#include "ringfilm/surface/topography/spectrum.hpp"

// usage: surface_analysis [--quick] [--benchmark_out=FILE] [--benchmark_filter=REGEX]
// How long a large height map takes to be levelled, filtered and analysed, and how much memory that needs beside the
// map itself; see docs/theory/surface.md.
namespace ringfilm::benchmarks {
namespace {

using namespace ringfilm::surface;

/// Steps of white noise over a gentle cylinder: the time depends on the size alone. A tenth of the points is missing
/// where asked.
HeightMap large_map(std::size_t points, bool holes) {
  HeightMap map{points, points, 1e-6, 1e-6, {}, {}};
  map.height_m.resize(map.points());
  if (holes) map.missing.assign(map.points(), 0);
  std::uint64_t state = 1;
  for (std::size_t i = 0; i < map.points(); ++i) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    const double y = (static_cast<double>(i / points) - 0.5 * static_cast<double>(points)) * 1e-6;
    map.height_m[i] = 1e-6 * (static_cast<double>(state >> 33) * 0x1.0p-31 - 0.5) - y * y / 4;
    if (!holes || (state >> 20) % 10 != 0) continue;
    map.missing[i] = 1;
    map.height_m[i] = 0;
  }
  return map;
}

/// Largest memory that the process has held so far [bytes].
double most_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

FilterChoice filter_of(FilterKind kind, FilterSide side, double cutoff_m) { return {kind, side, cutoff_m}; }

template <class Task>
void measure(const std::string& name, const HeightMap& map, const Task& task) {
  benchmark::RegisterBenchmark(name.c_str(),
                               [&map, task](benchmark::State& state) {
                                 for (auto _ : state) {
                                   state.PauseTiming();
                                   HeightMap work = map;
                                   state.ResumeTiming();
                                   task(work);
                                   benchmark::ClobberMemory();
                                 }
                                 state.counters["most_memory/map"] =
                                     most_memory() / (8.0 * static_cast<double>(map.points()));
                               })
      ->Unit(benchmark::kMillisecond)
      ->Iterations(1);
}

void register_all(const std::string& size, const HeightMap& map) {
  measure(size + "/level", map, [](HeightMap& work) { remove_form(work, {FormKind::tilt, 1}); });
  measure(size + "/cylinder", map, [](HeightMap& work) { remove_form(work, {FormKind::cylinder, 0}); });
  measure(size + "/short_filter", map,
          [](HeightMap& work) { apply_filter(work, filter_of(FilterKind::gaussian, FilterSide::short_cutoff, 5e-6)); });
  measure(size + "/long_filter", map, [](HeightMap& work) {
    apply_filter(work, filter_of(FilterKind::gaussian, FilterSide::long_cutoff, 250e-6));
  });
  measure(size + "/robust_long_filter", map, [](HeightMap& work) {
    apply_filter(work, filter_of(FilterKind::robust_gaussian, FilterSide::long_cutoff, 250e-6));
  });
  measure(size + "/heights_and_moments", map,
          [](HeightMap& work) { benchmark::DoNotOptimize(surface_measures(work)); });
  measure(size + "/bearing", map, [](HeightMap& work) {
    const std::vector<double> curve = material_ratio_curve(work);
    benchmark::DoNotOptimize(core_roughness(curve));
    benchmark::DoNotOptimize(probability_roughness(curve));
  });
  measure(size + "/summits", map, [](HeightMap& work) { benchmark::DoNotOptimize(count_summits(work)); });
  measure(size + "/line_spectra", map, [](HeightMap& work) {
    benchmark::DoNotOptimize(line_spectrum(work, LineDirection::x));
    benchmark::DoNotOptimize(line_spectrum(work, LineDirection::y));
  });
  measure(size + "/radial_spectrum", map, [](HeightMap& work) { benchmark::DoNotOptimize(radial_spectrum(work)); });
  measure(size + "/scale_table", map,
          [](HeightMap& work) { benchmark::DoNotOptimize(scale_table(work, short_cutoffs(work))); });
  measure(size + "/levelled_filtered_analysed", map, [](HeightMap& work) {
    remove_form(work, {FormKind::tilt, 1});
    apply_filter(work, filter_of(FilterKind::gaussian, FilterSide::short_cutoff, 5e-6));
    apply_filter(work, filter_of(FilterKind::gaussian, FilterSide::long_cutoff, 250e-6));
    benchmark::DoNotOptimize(surface_measures(work));
    const std::vector<double> curve = material_ratio_curve(work);
    benchmark::DoNotOptimize(core_roughness(curve));
    benchmark::DoNotOptimize(count_summits(work));
  });
}

int run(int argc, char** argv) {
  std::size_t points = 4096;
  benchmark::Initialize(&argc, argv);
  for (int i = 1; i < argc; ++i) {
    if (std::string(argv[i]) != "--quick") {
      std::fprintf(stderr, "surface_analysis: unknown argument %s\n", argv[i]);
      return 2;
    }
    points = 1024;
  }
  const HeightMap whole = large_map(points, false), holes = large_map(points, true);
  const std::string size = std::to_string(points) + "x" + std::to_string(points);
  register_all(size, whole);
  register_all(size + "/a_tenth_missing", holes);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}

}  // namespace
}  // namespace ringfilm::benchmarks

int main(int argc, char** argv) { return ringfilm::benchmarks::run(argc, argv); }
