#include <cmath>
#include <cstdint>

#include "measured_chain.hpp"
#include "measured_files.hpp"
#include "ringfilm/instrument/formats/digital_surf_file.hpp"
#include "ringfilm/instrument/formats/x3p_writer.hpp"
#include "ringfilm/surface/synthetic/random_numbers.hpp"
#include "ringfilm/surface/synthetic/target_surface.hpp"

namespace ringfilm::measured_files {
namespace {

using surface::HeightMap;

const surface::SurfaceGrid kGrid{256, 256, 0.4e-6, 0.4e-6};
constexpr double kTiltX = 1.2e-3, kTiltY = -0.8e-3;
constexpr int kMissingPoints = 40;

/// What the liner brings into all three pairs: well below the smoothest of them, the embedded ring's.
const surface::TargetSurface kLiner{surface::SigmaRule::ra, 0.2e-6, 0.015, 0.5e11};
constexpr std::uint64_t kLinerSeed = 20140;

/// Points where light did not come back.
void lose_points(HeightMap& map, std::uint64_t seed) {
  map.missing.assign(map.points(), 0);
  surface::RandomNumbers random(seed);
  for (int k = 0; k < kMissingPoints; ++k) {
    const auto point = static_cast<std::size_t>(random.uniform() * static_cast<double>(map.points()));
    map.missing[point] = 1;
    map.height_m[point] = 0;
  }
}

/// As the chain measures: mean over the regions.
surface::SurfaceMeasures measured(const HeightMap& map) {
  const instrument::SurfaceAnalysis analysis = app::chain::surface_analysis();
  instrument::SurfaceFile file;
  file.map = map;
  const std::vector<surface::SurfaceMeasures> regions =
      measures_of_regions(prepare_surface(file, analysis), analysis, nullptr);
  surface::SurfaceMeasures mean;
  const double share = 1 / static_cast<double>(regions.size());
  for (const surface::SurfaceMeasures& of : regions) {
    mean.Sa_m += share * of.Sa_m;
    mean.Sq_m += share * of.Sq_m;
    mean.moments.m2 += share * of.moments.m2;
    mean.moments.m4_per_m2 += share * of.moments.m4_per_m2;
  }
  return mean;
}

/// As it lay under the instrument.
void tilt(HeightMap& map) {
  for (std::size_t j = 0; j < map.points_y; ++j) {
    for (std::size_t i = 0; i < map.points_x; ++i) {
      double& height = map.height_m[map.index(i, j)];
      if (!map.measured(map.index(i, j))) continue;
      height += kTiltX * map.step_x_m * static_cast<double>(i) + kTiltY * map.step_y_m * static_cast<double>(j);
    }
  }
}

std::string maker_text(const std::string& what, std::uint64_t seed) {
  return "SYNTHETIC " + what + ", made by ringfilm (cases/measured), seed " + std::to_string(seed);
}

GeneratedFile liner_file() {
  HeightMap map = surface_with(kLiner, kGrid, kLinerSeed, measured);
  tilt(map);
  constexpr double kResolution_m = 0.1e-9;
  return {"liner.sur",
          instrument::digital_surf_bytes(map, kResolution_m, "SYNTHETIC liner", maker_text("liner", kLinerSeed))};
}

GeneratedFile ring_file(const TargetRing& ring, std::uint64_t seed) {
  const surface::TargetSurface requested = counterpart({ring.density_per_m2, ring.beta_m, ring.sigma_m}, kLiner);
  HeightMap map = surface_with(requested, kGrid, seed, [seed](const HeightMap& whole) {
    HeightMap with_holes = whole;
    lose_points(with_holes, seed);
    return measured(with_holes);
  });
  lose_points(map, seed);
  tilt(map);
  instrument::X3pOrigin origin;
  origin.manufacturer = "ringfilm (cases/measured),";
  origin.model = "SYNTHETIC ring " + ring.name + ", seed " + std::to_string(seed);
  origin.comment = maker_text("ring " + ring.name, seed);
  return {"ring_" + ring.name + ".x3p", x3p_bytes(map, instrument::X3pHeights::kInt16, origin)};
}

}  // namespace

std::vector<GeneratedFile> surface_files(const std::vector<TargetRing>& rings) {
  std::vector<GeneratedFile> files = {liner_file()};
  std::uint64_t seed = kLinerSeed;
  for (const TargetRing& ring : rings) files.push_back(ring_file(ring, ++seed));
  return files;
}

}  // namespace ringfilm::measured_files
