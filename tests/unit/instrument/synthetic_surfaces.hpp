#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "ringfilm/instrument/documents/surface_measurement.hpp"
#include "ringfilm/surface/synthetic/synthetic.hpp"

/// Surface files that no disk holds.
namespace ringfilm::instrument {

inline constexpr surface::SurfaceGrid kGrid{64, 48, 1e-6, 1e-6};

/// A Gaussian surface of 5 um correlation length.
inline SurfaceFile rough(const std::string& path, double Sq_m, std::uint64_t seed,
                         const surface::SurfaceGrid& grid = kGrid) {
  SurfaceFile file;
  file.map = gaussian_surface(grid, surface::gaussian_correlation(5e-6, 5e-6), Sq_m, seed);
  file.origin.path = path;
  file.origin.sha256 = "digest of " + path;
  file.plausibility_line = plausibility_line(file.map);
  return file;
}

inline bool holds(const std::vector<std::string>& lines, const std::string& words) {
  return std::any_of(lines.begin(), lines.end(),
                     [&](const std::string& line) { return line.find(words) != std::string::npos; });
}

inline double value(const io::Measurement& measurement, const std::string& name) {
  for (const io::MeasuredGroup& group : measurement.groups) {
    for (const io::MeasuredValue& of : group.values) {
      if (of.name == name) return of.value;
    }
  }
  ADD_FAILURE() << "there is no " << name;
  return 0;
}

}  // namespace ringfilm::instrument
