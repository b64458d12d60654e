#include "ringfilm/surface/synthetic/synthetic.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ringfilm/base/error.hpp"
#include "ringfilm/surface/synthetic/random_numbers.hpp"
#include "ringfilm/surface/synthetic/random_waves.hpp"
#include "ringfilm/surface/topography/roughness.hpp"

namespace ringfilm::surface {
namespace {

void check_positive(double value, const char* name) {
  if (std::isfinite(value) && value > 0) return;
  throw InputError("a synthetic surface needs a positive " + std::string(name) + ", not " + length_text(value));
}

/// Seeds of the parts of one surface.
std::uint64_t part_of(std::uint64_t seed, std::uint64_t part) { return seed * 0x2545f4914f6cdd1du + part; }

/// One family of parallel grooves.
struct Grooves {
  double sine, cosine, half_width_m;
  std::vector<double> place_m, depth_m;

  double depth_at(double x_m, double y_m) const {
    const double across = -x_m * sine + y_m * cosine;
    const auto after = std::lower_bound(place_m.begin(), place_m.end(), across - half_width_m);
    double deepest = 0;
    for (auto at = after; at != place_m.end() && *at < across + half_width_m; ++at) {
      const double depth = depth_m[static_cast<std::size_t>(at - place_m.begin())];
      deepest = std::max(deepest, depth * (1 - std::abs(across - *at) / half_width_m));
    }
    return deepest;
  }
};

Grooves make_grooves(const SurfaceGrid& grid, const HonedSurface& of, double angle_rad, RandomNumbers& random) {
  Grooves grooves{std::sin(angle_rad), std::cos(angle_rad), 0.5 * of.groove_width_m, {}, {}};
  const double reach = std::hypot(static_cast<double>(grid.points_x) * grid.step_x_m,
                                  static_cast<double>(grid.points_y) * grid.step_y_m) +
                       of.groove_width_m;
  double place = -reach + of.groove_spacing_m * random.uniform();
  while (place < reach) {
    grooves.place_m.push_back(place);
    grooves.depth_m.push_back(of.groove_depth_m * (0.5 + random.uniform()));
    place += of.groove_spacing_m * (0.5 + random.uniform());
  }
  return grooves;
}

}  // namespace

PowerSpectrum gaussian_correlation(double length_x_m, double length_y_m) {
  check_positive(length_x_m, "correlation length");
  check_positive(length_y_m, "correlation length");
  return [=](double fx, double fy) {
    const double a = std::numbers::pi * fx * length_x_m, b = std::numbers::pi * fy * length_y_m;
    return std::exp(-a * a - b * b);
  };
}

PowerSpectrum self_affine(double hurst, double roll_off_m, double short_m) {
  check_positive(roll_off_m, "roll-off wavelength");
  check_positive(short_m, "short wavelength");
  if (!(std::isfinite(hurst) && hurst >= 0 && hurst <= 1)) {
    throw InputError("a Hurst exponent lies between 0 and 1");
  }
  return [=](double fx, double fy) {
    const double square = fx * fx + fy * fy;
    return std::pow(1 + square * roll_off_m * roll_off_m, -1 - hurst) * std::exp(-square * short_m * short_m);
  };
}

HeightMap gaussian_surface(const SurfaceGrid& grid, const PowerSpectrum& spectrum, double Sq_m, std::uint64_t seed,
                           RmsDefinition rms) {
  check_positive(Sq_m, "rms height");
  HeightMap map = RandomWaves(grid, seed).surface(spectrum);
  double factor = Sq_m;
  if (rms == RmsDefinition::exact) {
    const HeightStatistics heights = height_statistics(map);
    for (double& height : map.height_m) height -= heights.mean_m;
    factor /= heights.Sq_m;
  }
  for (double& height : map.height_m) height *= factor;
  return map;
}

HeightMap honed_surface(const SurfaceGrid& grid, const HonedSurface& of, std::uint64_t seed) {
  check_positive(of.groove_spacing_m, "groove spacing");
  check_positive(of.groove_width_m, "groove width");
  check_positive(of.groove_depth_m, "groove depth");
  HeightMap map = gaussian_surface(grid, gaussian_correlation(of.plateau_length_m, of.plateau_length_m),
                                   of.plateau_Sq_m, part_of(seed, 1));
  const double extent_m =
      static_cast<double>(grid.points_x) * grid.step_x_m + static_cast<double>(grid.points_y) * grid.step_y_m;
  if (extent_m / of.groove_spacing_m > 1e6 || of.groove_width_m / of.groove_spacing_m > 1e3) {
    throw InputError("a groove spacing of " + length_text(of.groove_spacing_m) + " is too fine for the map");
  }
  RandomNumbers random(part_of(seed, 2));
  const Grooves rising = make_grooves(grid, of, 0.5 * of.hatch_angle_rad, random);
  const Grooves falling = make_grooves(grid, of, -0.5 * of.hatch_angle_rad, random);
  for (std::size_t j = 0; j < map.points_y; ++j) {
    for (std::size_t i = 0; i < map.points_x; ++i) {
      const double x = static_cast<double>(i) * map.step_x_m, y = static_cast<double>(j) * map.step_y_m;
      map.height_m[map.index(i, j)] -= std::max(rising.depth_at(x, y), falling.depth_at(x, y));
    }
  }
  return map;
}

PorousMap porous_surface(const SurfaceGrid& grid, const PorousSurface& of, std::uint64_t seed) {
  check_positive(of.pore_depth_m, "pore depth");
  if (!(std::isfinite(of.pore_share) && of.pore_share >= 0 && of.pore_share <= 0.9)) {
    throw InputError("a share of pores lies between 0 and 0.9 of the area");
  }
  PorousMap made;
  made.map =
      gaussian_surface(grid, gaussian_correlation(of.fine_length_m, of.fine_length_m), of.fine_Sq_m, part_of(seed, 1));
  HeightMap& map = made.map;
  const std::vector<double> field =
      gaussian_surface(grid, gaussian_correlation(of.pore_length_m, of.pore_length_m), 1, part_of(seed, 2)).height_m;
  made.pore.assign(map.points(), 0);
  const auto pores = static_cast<std::size_t>(std::lround(of.pore_share * static_cast<double>(map.points())));
  if (pores == 0) return made;
  std::vector<std::size_t> order(map.points());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto edge = order.begin() + static_cast<std::ptrdiff_t>(pores);
  const auto lower = [&](std::size_t a, std::size_t b) {
    return field[a] < field[b] || (field[a] == field[b] && a < b);
  };
  std::nth_element(order.begin(), edge, order.end(), lower);
  const double wall = field[*edge];
  double sum = 0;
  for (auto at = order.begin(); at != edge; ++at) sum += wall - field[*at];
  const double factor = of.pore_depth_m * static_cast<double>(pores) / sum;
  for (auto at = order.begin(); at != edge; ++at) {
    map.height_m[*at] -= factor * (wall - field[*at]);
    made.pore[*at] = 1;
  }
  return made;
}

}  // namespace ringfilm::surface
