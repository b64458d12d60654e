#include "ringfilm/instrument/documents/contact_measurement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "ringfilm/base/error.hpp"
#include "ringfilm/instrument/documents/surface_values.hpp"
#include "ringfilm/io/measurement/contact_law_file.hpp"
#include "ringfilm/models/contact/persson.hpp"
#include "ringfilm/surface/contact/resampled_map.hpp"

namespace ringfilm::instrument {
namespace {

constexpr double kMuchLoadNextToMissing = 0.01;  // share of the load
constexpr double kManyMissingOfMaps = 0.05;      // share of the points of the maps
constexpr double kSteepSlope = 0.2;              // rms slope from which on small slopes are doubtful

/// Form and filters; of a mirrored map the size that transforms quickly.
PreparedSurface prepared(const SurfaceFile& file, const ContactAnalysis& analysis, std::vector<std::string>& notes) {
  SurfaceAnalysis alone;
  alone.preparation = analysis.preparation;
  const surface::HeightMap& map = file.map;
  const bool is_mirrored = analysis.edges == surface::MapEdges::mirrored;
  const std::size_t columns = is_mirrored ? surface::fast_size(map.points_x) : map.points_x;
  const std::size_t rows = is_mirrored ? surface::fast_size(map.points_y) : map.points_y;
  if (columns == map.points_x && rows == map.points_y) return prepare_surface(file, alone);
  notes.push_back(fmt::format("{}: the first {} x {} of {} x {} points are used, a size that transforms quickly",
                              file_name(file.origin.path), columns, rows, map.points_x, map.points_y));
  SurfaceFile part{part_of_map(map, {0, 0, columns, rows, 0}), file.origin, file.plausibility_line};
  return prepare_surface(part, alone);
}

using Point = surface::ContactLawPoint;

/// A column of the law.
struct Column {
  const char *name, *long_name, *symbol, *unit, *display_unit;
  double (*value)(const Point&);
};

/// The columns of the law, in their order.
constexpr Column kColumns[] = {
    {"separation", "distance of the mean planes of the undeformed surfaces", "h", "m", "um",
     [](const Point& of) { return of.mean.separation_m; }},
    {"contact_pressure", "contact pressure on the nominal area", "p", "Pa", "MPa",
     [](const Point& of) { return of.mean.pressure; }},
    {"real_area", "real contact area over the nominal one", "A", "1", "%",
     [](const Point& of) { return of.mean.area_share; }},
    {"mean_gap", "mean of the true gap", "<H>", "m", "um", [](const Point& of) { return of.mean.mean_gap_m; }},
    {"share_at_cap", "share of the contact at the hardness", "", "1", "%",
     [](const Point& of) { return of.mean.share_at_cap; }},
    {"spot_radius", "radius of the mean contact spot", "", "m", "um",
     [](const Point& of) { return of.mean.spot_radius_m; }},
    {"spot_density", "contact spots per area", "", "m-2", "mm-2", [](const Point& of) { return of.mean.spots_per_m2; }},
    {"residual", "rms violation of the complementarity over Sq", "", "1", "1",
     [](const Point& of) { return of.mean.residual; }},
};

/// Columns for two relative positions and more.
constexpr Column kShiftColumns[] = {
    {"contact_pressure_deviation", "standard deviation of the pressure over relative positions", "s(p)", "Pa", "MPa",
     [](const Point& of) { return of.pressure_deviation; }},
    {"real_area_deviation", "standard deviation of the real contact area over relative positions", "s(A)", "1", "%",
     [](const Point& of) { return of.area_deviation; }},
};

constexpr Column kFlowColumns[] = {
    {"phi_x", "pressure flow factor along the rows", "phi_x", "1", "1", [](const Point& of) { return of.flow.phi_x; }},
    {"phi_y", "pressure flow factor across the rows", "phi_y", "1", "1", [](const Point& of) { return of.flow.phi_y; }},
    {"phi_s", "shear flow factor along the rows, first surface at rest", "phi_s", "1", "1",
     [](const Point& of) { return of.flow.phi_s; }},
    {"phi_fp", "stress factor of the pressure flow along the rows", "phi_fp", "1", "1",
     [](const Point& of) { return of.flow.phi_fp; }},
    {"flow_residual", "largest relative residual of the cell problems", "", "1", "1",
     [](const Point& of) { return of.flow.residual; }},
};

constexpr Column kRegionColumns[] = {
    {"contact_pressure_deviation_of_regions", "standard deviation of the pressure over regions", "s_r(p)", "Pa", "MPa",
     [](const Point& of) { return of.pressure_deviation_of_regions; }},
    {"real_area_deviation_of_regions", "standard deviation of the real contact area over regions", "s_r(A)", "1", "%",
     [](const Point& of) { return of.area_deviation_of_regions; }},
};

io::MeasuredTable law_table(const surface::ContactLaw& law, const ContactAnalysis& analysis) {
  io::MeasuredTable table{io::kContactLawTable, "Contact law", {}, {}, {}};
  const auto add = [&](std::span<const Column> columns) {
    for (const Column& column : columns) {
      std::vector<double>& rows =
          add_column(table, column.name, column.long_name, column.symbol, column.unit, column.display_unit);
      for (const Point& point : law.points) rows.push_back(column.value(point));
    }
  };
  add(kColumns);
  if (analysis.shifts > 1) add(kShiftColumns);
  if (analysis.regions_across * analysis.regions_down > 1) add(kRegionColumns);
  if (analysis.has_flow) add(kFlowColumns);
  return table;
}

double pressure_band(const Point& of) { return std::hypot(of.pressure_deviation, of.pressure_deviation_of_regions); }
double area_band(const Point& of) { return std::hypot(of.area_deviation, of.area_deviation_of_regions); }

std::vector<Point> rising_points(const surface::ContactLaw& law) {
  std::vector<Point> points = law.points;
  std::stable_sort(points.begin(), points.end(),
                   [](const Point& a, const Point& b) { return a.mean.separation_m < b.mean.separation_m; });
  return points;
}

/// A column of the law over the separation, smallest first.
/// @param deviation returns the deviation of a point, drawn as a band; nullptr: none
io::MeasuredCurve law_curve(const surface::ContactLaw& law, const Column& column, const std::string& name,
                            double (*deviation)(const Point&) = nullptr) {
  const std::vector<Point> points = rising_points(law);
  io::MeasuredCurve curve = curve_of(
      name, std::string(1, static_cast<char>(std::toupper(column.long_name[0]))) + (column.long_name + 1),
      "Against the distance of the mean planes of the undeformed surfaces.", {"separation", "separation", "m", "um"},
      {column.name, column.long_name, column.unit, column.display_unit});
  io::MeasuredSeries series{column.name, column.long_name, {}, false};
  for (const Point& point : points) {
    curve.x.push_back(point.mean.separation_m);
    series.y.push_back(column.value(point));
  }
  curve.series.push_back(std::move(series));
  if (deviation != nullptr) {
    const std::vector<double> mean = curve.series.front().y;
    for (const double sign : {-1.0, 1.0}) {
      io::MeasuredSeries edge{sign < 0 ? "lower" : "upper",
                              sign < 0 ? "less one standard deviation" : "plus one standard deviation",
                              {},
                              false};
      for (std::size_t k = 0; k < points.size(); ++k) {
        edge.y.push_back(std::max(0.0, mean[k] + sign * deviation(points[k])));
      }
      curve.series.push_back(std::move(edge));
    }
  }
  return curve;
}

/// Share of the area at each true gap, a series for each separation in the order of the table; six of them are drawn.
io::MeasuredCurve gap_curve(const surface::ContactLaw& law) {
  io::MeasuredCurve curve = curve_of(io::kGapDistribution, "Distribution of the true gap",
                                     "Share of the area at each gap; what is missing from 1 is contact.",
                                     {"gap", "true gap", "m", "um", true}, {"share", "share of the area", "1", "%"});
  curve.x = law.gap_places_m;
  const std::size_t step = (law.points.size() + 5) / 6;
  for (const Point& point : law.points) {
    const std::size_t k = curve.series.size();
    const std::string label = k % step == 0 ? "h = " + surface::length_text(point.mean.separation_m) : std::string();
    curve.series.push_back({io::gap_series(k), label, point.flow.gap_share, false});
  }
  return curve;
}

io::MeasuredMap pressure_map(const surface::ContactLaw& law) {
  double smallest = std::numeric_limits<double>::max();
  for (const Point& point : law.points) smallest = std::min(smallest, point.mean.separation_m);
  io::MeasuredMap picture;
  picture.name = "contact_map";
  picture.title = "Contact map";
  picture.caption = fmt::format("Contact pressure at a separation of {}, first relative position; 0: no contact.",
                                surface::length_text(smallest));
  picture.points_x = law.grid.points_x;
  picture.points_y = law.grid.points_y;
  picture.step_x = law.grid.step_x_m;
  picture.step_y = law.grid.step_y_m;
  picture.long_name = "contact pressure";
  picture.unit = "Pa";
  picture.display_unit = "MPa";
  picture.values = law.pressure;
  return picture;
}

io::MeasuredGroup law_group(const surface::ContactLaw& law, const ContactAnalysis& analysis) {
  Group group("The pair in contact");
  double residual = 0, iterations = 0;
  for (const Point& point : law.points) {
    residual = std::max(residual, point.mean.residual);
    iterations += point.mean.iterations;
  }
  group.add("composite_roughness", "rms height of the sum of both surfaces", "Sq", "m", "um", law.Sq_m);
  group.add("highest_point", "highest point of the sum above its mean plane", "", "m", "um", law.highest_m);
  group.add("composite_modulus", "composite modulus", "E'", "Pa", "GPa", 2 * analysis.material.E_star);
  if (analysis.material.hardness) {
    group.add("hardness", "hardness of the softer face", "H", "Pa", "GPa", *analysis.material.hardness);
  }
  group.add("relative_positions", "relative positions of both surfaces", "", "1", "1",
            static_cast<double>(analysis.shifts));
  group.add("missing_share", "share of the points without a height", "", "1", "%", law.missing_share);
  group.add(io::kLastSupportedSeparation, "largest separation at which five spots of a map or more carry", "", "m",
            "um", law.last_supported_m);
  group.add("complementarity_residual", "largest rms violation of the complementarity over Sq", "", "1", "1", residual);
  group.add("iterations", "iterations of the conjugate gradients", "", "1", "1", iterations);
  return group;
}

/// ln p of a sample: ln p(h - dh) + ds.
io::MeasuredGroup law_scatter_group(const surface::LawScatter& scatter) {
  Group group("Scatter of one relative position and one region");
  group.add("law_samples", "relative positions and regions beyond the first", "", "1", "1",
            static_cast<double>(scatter.samples));
  group.add(io::kShiftDeviation, "standard deviation of the shift of the separation", "s(dh)", "m", "nm",
            scatter.shift_deviation());
  group.add(io::kLogPressureDeviation, "standard deviation of the logarithm of the pressure", "s(ln p)", "1", "%",
            scatter.log_deviation());
  group.add(io::kShiftPressureCorrelation, "correlation of both", "", "1", "1", scatter.correlation());
  return group;
}

/// The law of the first position with half of the short cut-off and with twice of it, over that with it.
struct CutoffLaw {
  double factor;
  const char *name, *long_name;
};
constexpr CutoffLaw kOtherCutoffs[] = {
    {0.5, "pressure_ratio_half_cutoff", "pressure with half of the short cut-off over that with it, first position"},
    {2.0, "pressure_ratio_twice_cutoff", "pressure with twice the short cut-off over that with it, first position"}};

double rms_slope(const surface::HeightMap& map) {
  double squares = 0, count = 0;
  const auto add = [&](std::size_t a, std::size_t b, double step) {
    if (!map.measured(a) || !map.measured(b)) return;
    const double slope = (map.height_m[b] - map.height_m[a]) / step;
    squares += slope * slope;
    count += 1;
  };
  for (std::size_t j = 0; j < map.points_y; ++j) {
    for (std::size_t i = 0; i < map.points_x; ++i) {
      if (i + 1 < map.points_x) add(map.index(i, j), map.index(i + 1, j), map.step_x_m);
      if (j + 1 < map.points_y) add(map.index(i, j), map.index(i, j + 1), map.step_y_m);
    }
  }
  const double directions = map.is_profile() ? 1 : 2;
  return count > 0 ? std::sqrt(directions * squares / count) : 0;
}

double pair_slope(const surface::SurfacePair& pair) {
  return std::hypot(rms_slope(pair.first), pair.second ? rms_slope(*pair.second) : 0.0);
}

/// The area after Persson at the pressures of the law, eq-persson-area, smallest separation first.
io::MeasuredSeries persson_series(const surface::SurfacePair& pair, const surface::ContactLaw& law) {
  const std::vector<Point> points = rising_points(law);
  const double modulus = pair.material.E_star * pair_slope(pair);
  io::MeasuredSeries series{"persson", "Persson's area at the same pressure", {}, false};
  for (const Point& point : points) {
    const double p = point.mean.pressure;
    series.y.push_back(pair.material.hardness && p < *pair.material.hardness
                           ? models::persson_area(p, modulus, *pair.material.hardness).total()
                           : models::persson_area(p, modulus));
  }
  return series;
}

std::vector<std::string> law_notes(const surface::SurfacePair& pair, const surface::ContactLaw& law) {
  std::vector<std::string> notes;
  if (pair.first.is_profile()) notes.push_back("profiles are computed as ridges without end across them");
  if (law.missing_share > kManyMissingOfMaps) {
    notes.push_back(fmt::format("{:.3g} % of the points have no height; they never touch", 100 * law.missing_share));
  }
  double near_missing = 0;
  for (const Point& point : law.points) near_missing = std::max(near_missing, point.mean.load_next_to_missing);
  if (near_missing > kMuchLoadNextToMissing) {
    notes.push_back(fmt::format("up to {:.3g} % of the load is next to points without a height", 100 * near_missing));
  }
  const double slope = pair_slope(pair);
  if (slope > kSteepSlope) {
    notes.push_back(fmt::format("the rms slope of the pair is {:.2g}: half-space theory is for small slopes, below {}",
                                slope, kSteepSlope));
  }
  if (pair.second && pair.shifts < 2) {
    notes.push_back("one relative position is one sample: --shifts 8 gives a mean and its scatter");
  }
  if (!pair.material.hardness) notes.push_back("elastic: no hardness limits the pressure of the spots");
  return notes;
}

std::vector<std::string> statements_of(const ContactAnalysis& analysis, const PreparedSurface& first) {
  std::vector<std::string> lines = first.prepared.lines();
  lines.push_back(analysis.edges == surface::MapEdges::periodic ? "the maps repeat beyond their edges (periodic)"
                                                                : "the maps continue by their mirror images");
  lines.push_back("separation: distance of the mean planes of the undeformed surfaces");
  lines.push_back(analysis.material.hardness ? "elastic half-space, perfectly plastic at the hardness"
                                             : "elastic half-space");
  if (analysis.has_flow) {
    lines.push_back("flow factors: of the true gap, relative to the separation; motion along the rows of the maps");
  }
  lines.push_back("real area corrected for the pixels along the edges of spots");
  return lines;
}

/// Both maps as they meet, with the lines that report where they come from.
struct PreparedPair {
  surface::SurfacePair pair;
  PreparedSurface first;
  std::vector<std::string> sources;
};

/// On the finer steps of another map, with a note.
SurfaceFile on_steps_of(const SurfaceFile& file, double step_x, double step_y, std::vector<std::string>& notes) {
  const surface::HeightMap& map = file.map;
  if (same_step(map.step_x_m, step_x) && (map.is_profile() || same_step(map.step_y_m, step_y))) return file;
  notes.push_back(
      fmt::format("{}: steps of {} x {} are interpolated to {} x {}, those of the other map; its waves "
                  "below {} are not part of the law",
                  file_name(file.origin.path), surface::length_text(map.step_x_m), surface::length_text(map.step_y_m),
                  surface::length_text(step_x), surface::length_text(step_y),
                  surface::length_text(2 * std::max(map.step_x_m, map.is_profile() ? 0 : map.step_y_m))));
  return {surface::resampled(map, step_x, step_y), file.origin, file.plausibility_line};
}

PreparedPair prepared_pair(const SurfaceFile& first, const SurfaceFile* second, const ContactAnalysis& analysis,
                           std::vector<std::string>& notes) {
  std::optional<SurfaceFile> one, other;
  const bool is_resampled = second != nullptr && analysis.edges == surface::MapEdges::mirrored &&
                            first.map.is_profile() == second->map.is_profile() && steps_differ(first.map, second->map);
  // Periodic maps are not resampled: their periods would differ, and surface::sum_of_surfaces refuses them.
  if (is_resampled) {
    const double step_x = std::min(first.map.step_x_m, second->map.step_x_m);
    const double step_y = std::min(first.map.step_y_m, second->map.step_y_m);
    one = on_steps_of(first, step_x, step_y, notes);
    other = on_steps_of(*second, step_x, step_y, notes);
  }
  PreparedPair of{{}, prepared(one ? *one : first, analysis, notes), {}};
  of.sources = source_lines(of.first);
  of.pair = {of.first.map,          {},
             analysis.edges,        analysis.material,
             analysis.shifts,       analysis.regions_across,
             analysis.regions_down, analysis.has_flow};
  if (second == nullptr) return of;
  const PreparedSurface prepared_second = prepared(other ? *other : *second, analysis, notes);
  for (std::string& line : source_lines(prepared_second)) of.sources.push_back(std::move(line));
  of.pair.second = prepared_second.map;
  return of;
}

/// By how much the short cut-off decides: the ratios of pressures as columns, NaN without contact. @param with those of
/// the cut-off that is stated
void add_other_cutoffs(const SurfaceFile& first, const SurfaceFile* second, const ContactAnalysis& analysis,
                       const std::vector<double>& separations, const std::vector<double>& with,
                       io::MeasuredTable& table, std::vector<std::string>& notes) {
  const auto pressures = [&](double factor) {
    ContactAnalysis changed = analysis;
    changed.preparation.short_cutoff_m = factor * *analysis.preparation.short_cutoff_m;
    std::vector<std::string> known;
    std::vector<double> of;
    for (const auto& contact :
         surface::contact_of_first_position(prepared_pair(first, second, changed, known).pair, separations)) {
      of.push_back(contact.pressure);
    }
    return of;
  };
  for (const CutoffLaw& other : kOtherCutoffs) {
    std::vector<double> ratio(separations.size(), std::numeric_limits<double>::quiet_NaN());
    try {
      const std::vector<double> without = pressures(other.factor);
      for (std::size_t k = 0; k < ratio.size(); ++k) {
        if (with[k] > 0) ratio[k] = without[k] / with[k];
      }
    } catch (const InputError& refusal) {
      notes.push_back(fmt::format("the law with {:g} times the short cut-off is not computed: {}", other.factor,
                                  refusal.faults().front().message));
    }
    add_column(table, other.name, other.long_name, "", "1", "1") = std::move(ratio);
  }
}

}  // namespace

io::Measurement contact_measurement(const SurfaceFile& first, const SurfaceFile* second,
                                    const ContactAnalysis& analysis) {
  io::Measurement all;
  all.kind = io::kContactLawKind;
  add_doubts(&first, all.notes);
  add_doubts(second, all.notes);
  const PreparedPair prepared = prepared_pair(first, second, analysis, all.notes);
  const surface::SurfacePair& pair = prepared.pair;
  all.title = "Contact law of " + file_name(first.origin.path) + " with " +
              (second != nullptr ? file_name(second->origin.path) : std::string("a smooth flat"));
  all.sources = prepared.sources;
  all.statements = statements_of(analysis, prepared.first);
  const std::vector<double> separations =
      analysis.separations_m.empty() ? surface::usual_separations(pair) : analysis.separations_m;
  const surface::ContactLaw law = surface::contact_law(pair, separations);

  for (std::string& note : law_notes(pair, law)) all.notes.push_back(std::move(note));
  all.groups.push_back(law_group(law, analysis));
  all.key_values = {"composite_roughness", "highest_point", io::kLastSupportedSeparation};
  if (law.scatter.samples > 1) all.groups.push_back(law_scatter_group(law.scatter));
  all.tables.push_back(law_table(law, analysis));
  if (analysis.preparation.short_cutoff_m) {
    add_other_cutoffs(first, second, analysis, separations, law.first_pressure, all.tables.back(), all.notes);
  }
  const bool has_band = law.scatter.samples > 1;
  all.curves.push_back(law_curve(law, kColumns[1], "pressure_curve", has_band ? pressure_band : nullptr));
  all.curves.push_back(law_curve(law, kColumns[2], "area_curve", has_band ? area_band : nullptr));
  all.curves.back().series.push_back(persson_series(pair, law));
  if (analysis.has_flow) {
    for (const Column& column : {kFlowColumns[0], kFlowColumns[1], kFlowColumns[2]}) {
      all.curves.push_back(law_curve(law, column, std::string(column.name) + "_curve"));
    }
    all.curves.push_back(gap_curve(law));
  }
  if (!pair.first.is_profile()) all.maps.push_back(pressure_map(law));
  return all;
}

}  // namespace ringfilm::instrument
