#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ringfilm/base/display.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/instrument/documents/surface_measurement.hpp"
#include "ringfilm/instrument/documents/surface_values.hpp"
#include "ringfilm/surface/topography/roughness.hpp"

namespace ringfilm::instrument {
namespace {

std::vector<surface::Region> chosen_regions(const surface::HeightMap& map, const RegionChoice& choice) {
  std::vector<surface::Region> regions;
  for (const auto& [x, y, width, height] : choice.rectangles_m) {
    regions.push_back(surface::region_in_metres(map, x, y, width, height));
  }
  if (choice.across > 0) {
    const auto parts = surface::grid_regions(map, choice.across, choice.down);
    regions.insert(regions.end(), parts.begin(), parts.end());
  }
  if (choice.prominent > 0) {
    const auto points = [&](double step) {
      return static_cast<std::size_t>(std::llround(std::min(choice.size_m / step, static_cast<double>(kMaxPoints))));
    };
    const auto parts = surface::prominent_regions(map, choice.prominent, points(map.step_x_m), points(map.step_y_m));
    regions.insert(regions.end(), parts.begin(), parts.end());
  }
  return regions;
}

/// A map is filtered once for each cut-off: of a large one its middle reports as much.
surface::HeightMap middle_part(const surface::HeightMap& map) {
  constexpr std::size_t kMax = 1024;
  const auto across = std::min(map.points_x, map.is_profile() ? kMax * kMax : kMax);
  const auto down = std::min(map.points_y, kMax);
  return part_of_map(map, {(map.points_x - across) / 2, (map.points_y - down) / 2, across, down});
}

}  // namespace

PreparedSurface prepare_surface(const SurfaceFile& file, const SurfaceAnalysis& analysis) {
  PreparedSurface surface{file.origin, file.plausibility_line, file.map, {}, {}, {}};
  surface::Preparation form_alone;
  form_alone.form = analysis.preparation.form;
  surface.prepared = prepare(surface.map, form_alone);
  surface.middle = middle_part(surface.map);
  surface::Preparation filters = analysis.preparation;
  filters.form = {surface::FormKind::none};
  surface.prepared.filters = prepare(surface.map, filters).filters;
  surface.regions = chosen_regions(surface.map, analysis.regions);
  return surface;
}

namespace {

/// What `measure` returns of each region, or of the whole map.
template <class Measure>
auto of_regions(const PreparedSurface& surface, const Measure& measure) {
  std::vector<decltype(measure(surface.map))> measures;
  if (surface.regions.empty()) measures.push_back(measure(surface.map));
  for (const surface::Region& region : surface.regions) measures.push_back(measure(part_of_map(surface.map, region)));
  return measures;
}

}  // namespace

std::vector<surface::SurfaceMeasures> measures_of_regions(const PreparedSurface& surface,
                                                          const SurfaceAnalysis& analysis,
                                                          const surface::SpectralMoments* noise) {
  return of_regions(surface, [&](const surface::HeightMap& map) {
    surface::SurfaceMeasures of = surface_measures(map, analysis.direction, analysis.scheme);
    if (noise != nullptr) of.moments = without_noise(of.moments, *noise);
    return of;
  });
}

PlateauMeasures plateau_measures(const surface::HeightMap& map, const surface::ProbabilityRoughness& curve,
                                 const SurfaceAnalysis& analysis, const surface::SpectralMoments* noise) {
  const surface::HeightStatistics heights = height_statistics(map);
  PlateauMeasures of{curve, heights.Sq_m, curve.plateau_m - heights.mean_m,
                     moments(moment_table_above(map, curve.meet_m, analysis.scheme), analysis.direction)};
  if (noise != nullptr) of.moments = without_noise(of.moments, *noise);
  return of;
}

std::vector<PlateauMeasures> plateaus_of_regions(const PreparedSurface& surface, const SurfaceAnalysis& analysis,
                                                 const surface::SpectralMoments* noise) {
  return of_regions(surface, [&](const surface::HeightMap& map) {
    const auto curve = surface::probability_roughness(surface::material_ratio_curve(map));
    if (!curve) {
      throw InputError(surface.origin.path + " has no plateau over deeper valleys: over normal probability one line " +
                           "describes its material ratio curve as well as two",
                       "a surface made in one step is measured without --plateau; of a larger or levelled map two "
                       "lines may differ");
    }
    return plateau_measures(map, *curve, analysis, noise);
  });
}

surface::SpectralMoments noise_moments(const SurfaceFile& flat, const PreparedSurface& surface,
                                       const SurfaceAnalysis& analysis) {
  const auto differ = [](double a, double b) { return std::abs(a - b) > 1e-6 * b; };
  if (differ(flat.map.step_x_m, surface.map.step_x_m) ||
      (!surface.map.is_profile() && differ(flat.map.step_y_m, surface.map.step_y_m))) {
    throw InputError("the flat " + flat.origin.path + " has another step than " + surface.origin.path,
                     "noise depends on the step: measure the flat as the surface was measured");
  }
  SurfaceAnalysis alone = analysis;
  alone.regions = {};
  // A flat has no cylinder: its holder tilts it.
  using surface::FormKind;
  if (alone.preparation.form.kind == FormKind::cylinder) alone.preparation.form = {FormKind::tilt};
  return surface_measures(prepare_surface(flat, alone).map, analysis.direction, analysis.scheme).moments;
}

std::vector<std::string> source_lines(const PreparedSurface& surface) {
  const SurfaceOrigin& origin = surface.origin;
  const std::string name = origin.channel.empty() ? "" : " (" + origin.channel + ")";
  return origin_lines(origin, fmt::format(", channel {} of {}{}", origin.channel_number, origin.channels.size(), name),
                      surface.plausibility_line);
}

std::string measured_with(const PreparedSurface& surface) { return measured_with(surface.prepared, surface.map); }

std::string measured_with(const surface::Prepared& prepared, const surface::HeightMap& map) {
  std::string filters;
  for (const surface::FilterApplied& filter : prepared.filters) {
    const bool is_short = filter.choice.side == surface::FilterSide::short_cutoff;
    const bool is_robust = filter.choice.kind == surface::FilterKind::robust_gaussian;
    const bool is_two_step = filter.choice.kind == surface::FilterKind::valley_suppression && !is_short;
    filters += fmt::format("{}{}{}-filter {}", filters.empty() ? "" : ", ",
                           is_robust     ? "robust "
                           : is_two_step ? "ISO 13565-1 "
                                         : "",
                           is_short ? "S" : "L", text_in(filter.choice.cutoff_m, kMicrometre, 4));
  }
  const bool square = map.is_profile() || map.step_x_m == map.step_y_m;
  return (filters.empty() ? "no filter" : filters) + "; pixel " +
         (square ? "" : number_text(number_in(map.step_x_m, kMicrometre), 4) + " x ") +
         text_in(square ? map.step_x_m : map.step_y_m, kMicrometre, 4);
}

}  // namespace ringfilm::instrument
