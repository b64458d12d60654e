#include "ringfilm/instrument/documents/standard_surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ringfilm/base/error.hpp"
#include "ringfilm/instrument/documents/surface_values.hpp"
#include "ringfilm/surface/asperity/spectral_moments.hpp"
#include "ringfilm/surface/topography/areal_texture.hpp"
#include "ringfilm/surface/topography/roughness.hpp"

namespace ringfilm::instrument {
namespace {

constexpr double kSeries[] = {1, 2, 2.5, 5, 8};  // nesting indices of ISO 25178-3, times powers of ten
constexpr double kStepsInIndex = 3;              // an optical instrument samples an S-index three times: ISO 25178-3
constexpr double kWidest = 2;                    // fewest S-indices in an L-index of a surface that is reported
constexpr double kDecades = 1000;                // last index of the search over its first
constexpr double kRounding = 1 + 1e-9;           // steps and sides are sums

double shorter_side(const surface::HeightMap& map) {
  return std::min(map.step_x_m * static_cast<double>(map.points_x), map.step_y_m * static_cast<double>(map.points_y));
}

/// The largest index of the series that is not above a length, or the smallest that is not below it.
double index_at(double length_m, bool is_below) {
  const double decade = std::pow(10, std::floor(std::log10(length_m)) - 1);
  const double last = kDecades * decade;
  double best = is_below ? decade : last;
  for (double scale = decade; scale <= last; scale *= 10) {
    for (const double one : kSeries) {
      const double index = one * scale;
      if (is_below ? index <= length_m * kRounding && index > best : index * kRounding >= length_m && index < best) {
        best = index;
      }
    }
  }
  return best;
}

/// One of the two surfaces. @param name "SF" or "SL"
io::MeasuredGroup group_of(const std::string& name, const std::string& title, const surface::HeightMap& map,
                           const surface::Prepared& prepared, const SurfaceAnalysis& analysis) {
  Group group(title, "form removed: " + prepared.form.text + "; " + measured_with(prepared, map) + "; ISO 25178-2");
  const auto add = [&](const std::string& symbol, const char* words, double value, const char* unit,
                       const char* display) { group.add(name + "_" + symbol, words, symbol, unit, display, value); };
  const surface::HeightStatistics heights = height_statistics(map);
  add("Sa", "mean absolute deviation of heights", heights.Sa_m, "m", "um");
  add("Sq", "rms height", heights.Sq_m, "m", "um");
  add("Ssk", "skewness", heights.Ssk, "1", "1");
  add("Sku", "kurtosis", heights.Sku, "1", "1");
  add("Sp", "highest peak above the mean", heights.Sp_m, "m", "um");
  add("Sv", "deepest pit below the mean", heights.Sv_m, "m", "um");
  add("Sz", "peak to pit", heights.Sz_m, "m", "um");
  add("Sdq", "rms slope", rms_slope(moment_table(map, analysis.scheme)), "1", "1");
  add("Sdr", "developed interfacial area ratio", surface::developed_area_ratio(map), "1", "%");
  return group;
}

}  // namespace

surface::Preparation standard_preparation(const surface::HeightMap& map, const surface::Preparation& stated) {
  surface::Preparation standard = stated;
  if (stated.form.kind == surface::FormKind::none) standard.form = {surface::FormKind::polynomial, 2};
  if (!stated.short_cutoff_m) {
    standard.short_cutoff_m = index_at(kStepsInIndex * std::max(map.step_x_m, map.step_y_m), false);
  }
  if (!stated.long_cutoff_m) standard.long_cutoff_m = index_at(shorter_side(map), true);
  return standard;
}

std::vector<io::MeasuredGroup> standard_groups(const SurfaceFile& file, const SurfaceAnalysis& analysis,
                                               std::vector<std::string>& notes) {
  const surface::Preparation standard = standard_preparation(file.map, analysis.preparation);
  std::vector<io::MeasuredGroup> groups;
  const auto add = [&](const std::string& name, const std::string& words, bool has_l_filter) {
    const double shortest = *standard.short_cutoff_m;
    const double longest = has_l_filter ? *standard.long_cutoff_m : shorter_side(file.map);
    if (longest * kRounding < kWidest * shortest) {
      notes.push_back("no " + words + ": the S-filter of " + surface::length_text(shortest) + " leaves less than " +
                      "half of the " + (has_l_filter ? "L-filter of " : "shorter side of ") +
                      surface::length_text(longest));
      return;
    }
    surface::Preparation steps = standard;
    if (!has_l_filter) steps.long_cutoff_m.reset();
    surface::HeightMap map = file.map;
    try {
      const surface::Prepared prepared = prepare(map, steps);
      groups.push_back(group_of(name, words + " (ISO 25178-2)", map, prepared, analysis));
    } catch (const InputError& refusal) {
      notes.push_back("no " + words + ": " + refusal.faults().front().message);
    }
  };
  add("SF", "S-F surface", false);
  add("SL", "S-L surface", true);
  return groups;
}

}  // namespace ringfilm::instrument
