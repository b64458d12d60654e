#include "ringfilm/instrument/documents/surface_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>

#include "ringfilm/base/error.hpp"
#include "ringfilm/surface/topography/roughness.hpp"

namespace ringfilm::instrument {
namespace {

constexpr double kMuchTilt = 0.05;     // share of Sq that a plane removes
constexpr double kManyMissing = 0.05;  // share of all points that were not measured
constexpr double kSameStep = 1e-6;     // relative difference of two steps that are one

/// N, beta and sigma.
constexpr const char* kParameterNames[] = {"asperity_density", "asperity_radius", "roughness"};
constexpr const char* kParameterSymbols[] = {"N", "beta", "sigma"};

/// Reports how much a tilt that was left in adds, if it adds much.
std::optional<std::string> tilt_note(surface::HeightMap map) {
  try {
    const double as_read = height_statistics(map).Sq_m;
    surface::Preparation tilt;
    tilt.form = {surface::FormKind::tilt};
    prepare(map, tilt);
    const double levelled = height_statistics(map).Sq_m;
    if (levelled > (1 - kMuchTilt) * as_read) return std::nullopt;
    return "tilt was left in: without it the rms height falls from " + surface::length_text(as_read) + " to " +
           surface::length_text(levelled) + "; --form tilt";
  } catch (const InputError&) {  // no plane through these points: nothing to state of it
    return std::nullopt;
  }
}

std::string direction_text(surface::MomentDirection direction) {
  switch (direction) {
    case surface::MomentDirection::x:
      return "along x";
    case surface::MomentDirection::y:
      return "along y";
    case surface::MomentDirection::mean:
      return "mean of x and y";
    case surface::MomentDirection::geometric:
      return "geometric mean of x and y";
  }
  return "";
}

bool regions_overlap(const std::vector<surface::Region>& regions) {
  for (std::size_t i = 0; i < regions.size(); ++i) {
    for (std::size_t k = i + 1; k < regions.size(); ++k) {
      const surface::Region &a = regions[i], &b = regions[k];
      if (a.column < b.column + b.columns && b.column < a.column + a.columns && a.row < b.row + b.rows &&
          b.row < a.row + a.rows) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace

std::vector<double>& add_column(io::MeasuredTable& table, const std::string& name, const std::string& long_name,
                                const std::string& symbol, const std::string& unit, const std::string& display_unit) {
  table.columns.push_back({name, long_name, symbol, unit, display_unit, 0, std::nan(""), ""});
  return table.values.emplace_back();
}

void add_row(io::MeasuredTable& table, const std::vector<double>& values) {
  for (std::size_t c = 0; c < table.values.size(); ++c) table.values[c].push_back(values[c]);
}

void add_row(io::MeasuredTable& table, const std::string& label, const std::vector<double>& values) {
  add_row(table, values);
  table.row_labels.push_back(label);
}

io::MeasuredCurve curve_of(const std::string& name, const std::string& title, const std::string& caption,
                           const io::MeasuredAxis& x_axis, const io::MeasuredAxis& y_axis) {
  return {name, title, caption, x_axis, y_axis, {}, {}, {}};
}

std::vector<std::string> origin_lines(const SurfaceOrigin& origin, const std::string& channel,
                                      const std::string& plausibility_line) {
  std::string file = origin.path + ": " + origin.format;
  if (origin.channels.size() > 1) file += channel;
  if (!origin.instrument.empty()) file += ", " + origin.instrument;
  if (!origin.date.empty()) file += ", " + origin.date;
  std::vector<std::string> lines = {file, plausibility_line, "SHA-256 " + origin.sha256};
  lines.insert(lines.end(), origin.notes.begin(), origin.notes.end());
  return lines;
}

io::MeasuredFrame frame_of(const surface::Region& region, const surface::HeightMap& map, const std::string& label) {
  return {static_cast<double>(region.column) * map.step_x_m, static_cast<double>(region.row) * map.step_y_m,
          static_cast<double>(region.columns) * map.step_x_m, static_cast<double>(region.rows) * map.step_y_m, label};
}

bool same_step(double a_m, double b_m) { return std::abs(a_m / b_m - 1) <= kSameStep; }

bool steps_differ(const surface::HeightMap& a, const surface::HeightMap& b) {
  return !same_step(a.step_x_m, b.step_x_m) ||
         (!a.is_profile() && !b.is_profile() && !same_step(a.step_y_m, b.step_y_m));
}

std::string file_name(const std::string& path) { return std::filesystem::path(path).filename().string(); }

std::string surface_sigma_text(surface::SigmaRule rule) {
  return rule == surface::SigmaRule::ra ? "Ra (Sa)" : "Rq (Sq)";
}

std::string moment_text(const PreparedSurface& surface, const SurfaceAnalysis& analysis) {
  return scheme_text(analysis.scheme) + (surface.map.is_profile() ? "" : ", " + direction_text(analysis.direction));
}

std::vector<std::string> analysis_lines(const PreparedSurface& surface, const SurfaceAnalysis& analysis) {
  std::vector<std::string> lines = surface.prepared.lines();
  lines.push_back("spectral moments: " + moment_text(surface, analysis));
  return lines;
}

void add_doubts(const SurfaceFile* file, std::vector<std::string>& lines, const std::string& before) {
  if (file == nullptr) return;
  for (const std::string& doubt : file->origin.doubts) {
    lines.push_back(before + file_name(file->origin.path) + ": " + doubt);
  }
}

std::vector<std::string> surface_notes(const SurfaceFile& file, const PreparedSurface& surface,
                                       const SurfaceAnalysis& analysis) {
  std::vector<std::string> notes = file.origin.doubts;
  const auto kind = analysis.preparation.form.kind;
  if (kind == surface::FormKind::none || kind == surface::FormKind::mean) {
    if (auto note = tilt_note(file.map)) notes.push_back(std::move(*note));
  }
  if (!analysis.preparation.short_cutoff_m) {
    const surface::HeightMap& map = surface.map;
    const bool both = analysis.direction == surface::MomentDirection::mean ||
                      analysis.direction == surface::MomentDirection::geometric;
    if (both && !map.is_profile() && !same_step(map.step_x_m, map.step_y_m)) {
      notes.push_back("the steps of " + surface::length_text(map.step_x_m) + " along x and " +
                      surface::length_text(map.step_y_m) +
                      " along y differ: without --short-cutoff the slopes and curvatures along both do not belong "
                      "together");
    }
    notes.push_back("no short cut-off: m4, N and beta belong to the step of " +
                    surface::length_text(surface.map.step_x_m) + "; see the table against the cut-off");
  }
  if (regions_overlap(surface.regions)) {
    notes.push_back("regions overlap: they are not independent samples, and the scatter is too small");
  }
  const double missing = 1 - static_cast<double>(measured_points(file.map)) / static_cast<double>(file.map.points());
  if (missing > kManyMissing) {
    notes.push_back(
        fmt::format("{:.3g} % of the points were not measured; they are omitted everywhere", 100 * missing));
  }
  return notes;
}

Group asperity_group(const std::string& title, const surface::AsperityParameters& of, const std::string& remark,
                     const std::string& sigma_text) {
  Group group(title, remark);
  group.add("asperity_density", "density of asperity peaks", "N", "m-2", "mm-2", of.density_per_m2);
  group.add("asperity_radius", "mean summit radius", "beta", "m", "um", of.beta_m);
  group.add("roughness", "roughness in contact", "sigma", "m", "um", of.sigma_m, sigma_text);
  group.add("roughness_parameter", "0.03 to 0.05 after Greenwood and Tripp", "N beta sigma", "1", "1",
            of.roughness_parameter());
  group.add("slope_ratio", "roughness over radius", "sigma/beta", "1", "1", of.slope());
  return group;
}

io::MeasuredGroup scatter_group(const surface::ParameterScatter& scatter, const std::string& remark,
                                const std::string& sigma_text) {
  const surface::AsperityParameters mean{scatter.mean[0], scatter.mean[1], scatter.mean[2]};
  Group group = asperity_group(fmt::format("Asperities, mean of {} samples with its standard error", scatter.count),
                               mean, remark, sigma_text);
  std::array<double, 3> errors{};
  for (std::size_t k = 0; k < 3; ++k) errors[k] = scatter.mean[k] * scatter.relative_standard_error(k);
  add_scatter("standard deviation between regions, relative", errors, scatter.covariance_log, group);
  return group;
}

void add_scatter(const std::string& words, const std::array<double, 3>& standard_error,
                 const surface::ParameterScatter::Matrix& covariance_log, Group& group) {
  for (std::size_t k = 0; k < 3; ++k) {
    group.values[k].standard_error = standard_error[k];
    group.add(std::string(kParameterNames[k]) + "_relative_deviation", words,
              fmt::format("s(ln {})", kParameterSymbols[k]), "1", "%", std::sqrt(covariance_log[k][k]));
  }
  for (const auto& [a, b] : {std::pair{0, 1}, {1, 2}, {0, 2}}) {
    group.add(fmt::format("correlation_{}_{}", kParameterNames[a], kParameterNames[b]), "correlation between regions",
              fmt::format("r({}, {})", kParameterSymbols[a], kParameterSymbols[b]), "1", "1",
              surface::correlation(covariance_log, a, b));
  }
}

std::string few_samples_note(std::size_t samples) {
  return fmt::format("{} samples report little of deviations and less of correlations: name more files or regions",
                     samples);
}

io::MeasuredTable covariance_table(const surface::ParameterScatter::Matrix& covariance_log) {
  io::MeasuredTable table{
      "covariance", "Covariance of the logarithms of N, beta and sigma, of one sample of each surface", {}, {}, {}};
  for (std::size_t c = 0; c < 3; ++c) {
    const std::string symbol = std::string("ln ") + kParameterSymbols[c];
    add_column(table, std::string("covariance_with_") + kParameterNames[c], "with " + symbol, symbol, "1", "1") = {
        covariance_log[0][c], covariance_log[1][c], covariance_log[2][c]};
    table.row_labels.push_back(symbol);
  }
  return table;
}

io::MeasuredGroup summit_group(const std::string& title, const surface::Summits& summits,
                               const surface::AsperityParameters& of_moments, const std::string& remark) {
  Group group(title, remark);
  group.add("summit_count", "summits", "", "1", "1", static_cast<double>(summits.count));
  group.add("summit_density", "density of summits", "", "m-2", "mm-2", summits.density_per_m2);
  if (summits.count == 0) return group;
  group.add("summit_radius", "radius of their mean curvature", "", "m", "um", summits.mean_radius_m);
  group.add("summit_rms_height", "rms of their heights", "", "m", "um", summits.rms_height_m);
  group.add("summit_density_ratio", "counted density over N of the moments", "", "1", "1",
            summits.density_per_m2 / of_moments.density_per_m2);
  group.add("summit_radius_ratio", "counted radius over beta of the moments", "", "1", "1",
            summits.mean_radius_m / of_moments.beta_m);
  return group;
}

io::MeasuredTable region_table(const PreparedSurface& surface, const std::vector<surface::SurfaceMeasures>& measures,
                               const std::vector<surface::AsperityParameters>& parameters) {
  io::MeasuredTable table{"regions", "Regions", {}, {}, {}};
  add_column(table, "region_x", "left edge", "x", "m", "um");
  add_column(table, "region_y", "upper edge", "y", "m", "um");
  add_column(table, "region_width", "width", "", "m", "um");
  add_column(table, "region_height", "height", "", "m", "um");
  add_column(table, "region_Sa", "mean absolute deviation", "Sa", "m", "um");
  add_column(table, "region_Sq", "rms height", "Sq", "m", "um");
  add_column(table, "region_asperity_density", "density of asperity peaks", "N", "m-2", "mm-2");
  add_column(table, "region_asperity_radius", "mean summit radius", "beta", "m", "um");
  const bool proposed = std::any_of(surface.regions.begin(), surface.regions.end(),
                                    [](const surface::Region& region) { return region.prominence_m != 0; });
  if (proposed) add_column(table, "region_prominence", "prominence", "", "m", "um");
  for (std::size_t k = 0; k < surface.regions.size(); ++k) {
    const io::MeasuredFrame place = frame_of(surface.regions[k], surface.map, std::to_string(k + 1));
    add_row(table, place.label,
            {place.x, place.y, place.width, place.height, measures[k].Sa_m, measures[k].Sq_m,
             parameters[k].density_per_m2, parameters[k].beta_m, surface.regions[k].prominence_m});
  }
  return table;
}

}  // namespace ringfilm::instrument
