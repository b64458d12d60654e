#include "ringfilm/instrument/documents/surface_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "ringfilm/instrument/documents/surface_values.hpp"
#include "ringfilm/surface/asperity/scale.hpp"
#include "ringfilm/surface/topography/roughness.hpp"
#include "ringfilm/surface/topography/spectrum.hpp"

namespace ringfilm::instrument {
namespace {

constexpr double kNoHeight = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kMaterialRatioPoints = 1000;

double height_or_none(const surface::HeightMap& map, std::size_t point) {
  return map.measured(point) ? map.height_m[point] : kNoHeight;
}

}  // namespace

io::MeasuredMap height_map(const PreparedSurface& surface, const std::string& name) {
  const surface::HeightMap& map = surface.map;
  io::MeasuredMap picture;
  picture.name = name;
  picture.title = "Heights";
  picture.caption = fmt::format("After: {} removed; {}.", surface.prepared.form.text, measured_with(surface));
  picture.points_x = map.points_x;
  picture.points_y = map.points_y;
  picture.step_x = map.step_x_m;
  picture.step_y = map.step_y_m;
  picture.long_name = "height";
  picture.unit = std::string("m");
  picture.display_unit = "um";
  picture.values.resize(map.points());
  for (std::size_t i = 0; i < map.points(); ++i) picture.values[i] = height_or_none(map, i);
  for (std::size_t k = 0; k < surface.regions.size(); ++k) {
    picture.frames.push_back(frame_of(surface.regions[k], map, std::to_string(k + 1)));
  }
  return picture;
}

io::MeasuredCurve profile_curve(const PreparedSurface& surface) {
  const surface::HeightMap& map = surface.map;
  const std::size_t row = map.points_y / 2;
  io::MeasuredCurve curve = curve_of(
      "profile", "Profile",
      map.is_profile()
          ? "The profile after form and filters."
          : fmt::format("The middle row of the map, number {} of {}, after form and filters.", row + 1, map.points_y),
      {"x", "distance along the row", "m", "um"}, {"height", "height", "m", "um"});
  io::MeasuredSeries heights{"profile_height", "height", {}, false};
  for (std::size_t i = 0; i < map.points_x; ++i) {
    curve.x.push_back(static_cast<double>(i) * map.step_x_m);
    heights.y.push_back(height_or_none(map, map.index(i, row)));
  }
  curve.series.push_back(std::move(heights));
  return curve;
}

io::MeasuredCurve material_ratio_curve(const std::vector<double>& falling_heights_m) {
  io::MeasuredCurve curve =
      curve_of("material_ratio_curve", "Material ratio curve",
               "Share of the points that are higher (Abbott curve), all measured points of the map.",
               {"material_ratio", "material ratio", "1", "%"}, {"material_ratio_height", "height", "m", "um"});
  io::MeasuredSeries heights{"material_ratio_height", "height", {}, false};
  const std::size_t n = falling_heights_m.size();
  const std::size_t shown = std::min(n, kMaterialRatioPoints);
  for (std::size_t k = 0; k < shown; ++k) {
    const std::size_t i = shown == 1 ? 0 : k * (n - 1) / (shown - 1);
    curve.x.push_back((static_cast<double>(i) + 0.5) / static_cast<double>(n));
    heights.y.push_back(falling_heights_m[i]);
  }
  curve.series.push_back(std::move(heights));
  return curve;
}

io::MeasuredCurve spectrum_curve(const PreparedSurface& surface) {
  const surface::LineSpectrum along_x = line_spectrum(surface.map, surface::LineDirection::x);
  io::MeasuredCurve curve =
      curve_of("spectrum", "Power spectrum",
               std::string("Mean of the lines of the map, one-sided, ") + surface::kSpectrumWindow +
                   " window; its integral over the frequency is the mean square height.",
               {"spatial_frequency", "spatial frequency", "m-1", "mm-1", true},
               {"power_density", "power density", "m3", "um3", true});
  curve.x = along_x.frequency_per_m;
  curve.series.push_back({"power_density_x", "along x", along_x.density_m3, false});
  if (surface.map.is_profile()) return curve;
  // Along y the frequencies are others unless the map is square: taken over to those of x where they lie between.
  const surface::LineSpectrum along_y = line_spectrum(surface.map, surface::LineDirection::y);
  io::MeasuredSeries y{"power_density_y", "along y", {}, false};
  for (const double frequency : curve.x) {
    const auto& known = along_y.frequency_per_m;
    const auto above = std::lower_bound(known.begin(), known.end(), frequency * (1 - 1e-12));
    const auto i = static_cast<std::size_t>(above - known.begin());
    if (above == known.end() || (i == 0 && known[0] > frequency * (1 + 1e-9))) {
      y.y.push_back(kNoHeight);
    } else if (i == 0 || known[i] <= frequency * (1 + 1e-9)) {
      y.y.push_back(along_y.density_m3[i]);
    } else {
      const double share = (frequency - known[i - 1]) / (known[i] - known[i - 1]);
      y.y.push_back(along_y.density_m3[i - 1] + share * (along_y.density_m3[i] - along_y.density_m3[i - 1]));
    }
  }
  curve.series.push_back(std::move(y));
  return curve;
}

io::MeasuredTable scale_table(const PreparedSurface& surface, const SurfaceAnalysis& analysis) {
  const surface::HeightMap& part = surface.middle;
  io::MeasuredTable table{"scale", "Against the short cut-off, this surface against a smooth one", {}, {}, {}};
  if (part.points() < surface.map.points()) {
    table.title += fmt::format(", the middle {} x {} points", part.points_x, part.points_y);
  }
  add_column(table, "short_cutoff", "short cut-off", "lambda_s", "m", "um");
  add_column(table, "Sq", "rms height", "Sq", "m", "um");
  add_column(table, "Sdq", "rms slope", "Sdq", "1", "1");
  add_column(table, "m2", "variance of slopes", "m2", "1", "1");
  add_column(table, "m4", "variance of curvatures", "m4", "m-2", "mm-2");
  add_column(table, "asperity_density", "density of asperity peaks", "N", "m-2", "mm-2");
  add_column(table, "asperity_radius", "mean summit radius", "beta", "m", "um");
  if (!surface.map.is_profile()) add_column(table, "summit_density", "summits counted", "", "m-2", "mm-2");
  for (const surface::ScaleRow& row :
       surface::scale_table(part, short_cutoffs(part), analysis.direction, analysis.scheme)) {
    add_row(table, row.short_cutoff_m > 0 ? "" : "none, the step alone",
            {row.short_cutoff_m, row.Sq_m, row.Sdq, row.moments.m2, row.moments.m4_per_m2, row.density_per_m2,
             row.beta_m, row.summit_density_per_m2});
  }
  return table;
}

io::MeasuredCurve scale_curve(const io::MeasuredTable& table, const SurfaceAnalysis& analysis) {
  io::MeasuredCurve curve =
      curve_of("scale_curve", "Density and radius of asperities against the short cut-off",
               "Relative to their values without cut-off. N and beta of a surface depend on the cut-off: they belong "
               "to the wavelengths that are let in.",
               {"short_cutoff_of_curve", "short cut-off", "m", "um", true},
               {"relative_parameter", "relative to no cut-off", "1", "1", true});
  const auto& cutoffs = table.values[0];
  curve.x.assign(cutoffs.begin() + 1, cutoffs.end());
  for (const std::size_t column : {std::size_t{5}, std::size_t{6}, std::size_t{1}}) {
    io::MeasuredSeries series{"relative_" + table.columns[column].name, table.columns[column].symbol, {}, false};
    const auto& values = table.values[column];
    for (std::size_t k = 1; k < values.size(); ++k) series.y.push_back(values[k] / values[0]);
    curve.series.push_back(std::move(series));
  }
  if (analysis.preparation.short_cutoff_m) curve.marks.push_back({*analysis.preparation.short_cutoff_m, "in use"});
  return curve;
}

}  // namespace ringfilm::instrument
