#include "ringfilm/instrument/documents/surface_side.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>

#include "ringfilm/instrument/documents/surface_values.hpp"

namespace ringfilm::instrument {
namespace {

bool has_regions(const Side& side) {
  return std::any_of(side.surfaces.begin(), side.surfaces.end(),
                     [](const PreparedSurface& surface) { return !surface.regions.empty(); });
}

}  // namespace

Side measured_side(const std::string& name, const std::vector<SurfaceFile>& files, const SurfaceAnalysis& analysis,
                   const SurfaceFile* flat, CarryingPart carrying) {
  Side side{name, {}, {}, {}};
  for (const SurfaceFile& file : files) {
    side.surfaces.push_back(prepare_surface(file, analysis));
    std::optional<surface::SpectralMoments> noise;
    if (flat != nullptr) noise = noise_moments(*flat, side.surfaces.back(), analysis);
    const surface::SpectralMoments* const removed = noise ? &*noise : nullptr;
    if (carrying == CarryingPart::kPlateau) {
      for (const PlateauMeasures& of : plateaus_of_regions(side.surfaces.back(), analysis, removed)) {
        const double Rpq = of.curve.Rpq_m;
        side.measures.push_back({Rpq * std::sqrt(2 / std::numbers::pi), Rpq, of.moments});
        side.plateaus.push_back(of);
      }
      continue;
    }
    auto measures = measures_of_regions(side.surfaces.back(), analysis, removed);
    std::move(measures.begin(), measures.end(), std::back_inserter(side.measures));
  }
  return side;
}

std::string names_of(const Side& side) {
  std::string names;
  for (const PreparedSurface& surface : side.surfaces) {
    names += (names.empty() ? "" : ", ") + file_name(surface.origin.path);
  }
  const std::size_t count = side.measures.size();
  if (has_regions(side)) names += fmt::format(" ({} {})", count, count == 1 ? "region" : "regions");
  return names;
}

std::vector<std::string> digest_lines(const Side& side) {
  std::vector<std::string> lines;
  for (const PreparedSurface& surface : side.surfaces) {
    const SurfaceOrigin& origin = surface.origin;
    lines.push_back(fmt::format("{}: {}{}, SHA-256 {}", side.name, file_name(origin.path),
                                origin.channels.size() > 1 ? fmt::format(", channel {}", origin.channel_number) : "",
                                origin.sha256));
  }
  return lines;
}

io::MeasuredTable side_table(const Side& side, const SurfaceAnalysis& analysis, const std::string& title) {
  io::MeasuredTable table{side.name + "_measures", title, {}, {}, {}};
  const auto column = [&](const char* tail, const char* words, const char* symbol, const char* unit,
                          const char* display) {
    add_column(table, side.name + "_" + tail, words, symbol, unit, display);
  };
  column("Sa", "mean absolute deviation", "Sa", "m", "um");
  column("Sq", "rms height", "Sq", "m", "um");
  column("m2", "variance of slopes", "m2", "1", "1");
  column("m4", "variance of curvatures", "m4", "m-2", "mm-2");
  column("asperity_density", "density against a smooth surface", "N", "m-2", "mm-2");
  column("asperity_radius", "radius against a smooth surface", "beta", "m", "um");
  if (has_regions(side)) {
    column("region_x", "left edge", "x", "m", "um");
    column("region_y", "upper edge", "y", "m", "um");
    column("region_width", "width", "w", "m", "um");
    column("region_height", "height", "h", "m", "um");
  }
  std::size_t next = 0;
  for (const PreparedSurface& surface : side.surfaces) {
    const std::size_t parts = std::max<std::size_t>(surface.regions.size(), 1);
    for (std::size_t k = 0; k < parts; ++k, ++next) {
      const surface::SurfaceMeasures& of = side.measures[next];
      const surface::AsperityParameters alone = single_parameters(of, analysis.sigma_rule);
      const surface::HeightMap& map = surface.map;
      const surface::Region part =
          surface.regions.empty() ? surface::Region{0, 0, map.points_x, map.points_y, 0} : surface.regions[k];
      const io::MeasuredFrame place =
          frame_of(part, map, surface.regions.empty() ? std::string() : fmt::format(", region {}", k + 1));
      add_row(table, file_name(surface.origin.path) + place.label,
              {of.Sa_m, of.Sq_m, of.moments.m2, of.moments.m4_per_m2, alone.density_per_m2, alone.beta_m, place.x,
               place.y, place.width, place.height});
    }
  }
  return table;
}

}  // namespace ringfilm::instrument
