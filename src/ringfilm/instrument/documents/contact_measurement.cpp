#include "ringfilm/instrument/documents/contact_measurement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "ringfilm/base/error.hpp"
#include "ringfilm/instrument/documents/surface_values.hpp"
#include "ringfilm/io/measurement/contact_law_file.hpp"

namespace ringfilm::instrument {
namespace {

constexpr double kMuchLoadNextToMissing = 0.01;  // of the load
constexpr double kManyMissingOfMaps = 0.05;      // of the points
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

/// The columns of the law, in their order.
struct Column {
  const char *name, *long_name, *symbol, *unit, *display_unit;
  double (*value)(const surface::ContactLawPoint&);
};

using Point = surface::ContactLawPoint;
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
    {"contact_pressure_deviation", "standard deviation of the pressure over relative positions", "s(p)", "Pa", "MPa",
     [](const Point& of) { return of.pressure_deviation; }},
    {"real_area_deviation", "standard deviation of the real contact area over relative positions", "s(A)", "1", "%",
     [](const Point& of) { return of.area_deviation; }},
    {"residual", "rms violation of the complementarity over Sq", "", "1", "1",
     [](const Point& of) { return of.mean.residual; }},
};

constexpr Column kFlowColumns[] = {
    {"phi_x", "pressure flow factor along the rows", "phi_x", "1", "1", [](const Point& of) { return of.flow.phi_x; }},
    {"phi_y", "pressure flow factor across the rows", "phi_y", "1", "1", [](const Point& of) { return of.flow.phi_y; }},
    {"phi_s", "shear flow factor along the rows, first surface at rest", "phi_s", "1", "1",
     [](const Point& of) { return of.flow.phi_s; }},
    {"flow_residual", "largest relative residual of the cell problems", "", "1", "1",
     [](const Point& of) { return of.flow.residual; }},
};

io::MeasuredTable law_table(const surface::ContactLaw& law, const ContactAnalysis& analysis) {
  io::MeasuredTable table;
  table.name = io::kContactLawTable;
  table.title = "Contact law";
  const auto add = [&](const Column& column) {
    add_column(table, column.name, column.long_name, column.symbol, column.unit, column.display_unit);
    for (const Point& point : law.points) table.values.back().push_back(column.value(point));
  };
  for (const Column& column : kColumns) add(column);
  if (analysis.has_flow) {
    for (const Column& column : kFlowColumns) add(column);
  }
  return table;
}

/// A column of the law over the separation, smallest first.
io::MeasuredCurve law_curve(const surface::ContactLaw& law, const Column& column, const std::string& name) {
  std::vector<Point> points = law.points;
  std::stable_sort(points.begin(), points.end(),
                   [](const Point& a, const Point& b) { return a.mean.separation_m < b.mean.separation_m; });
  io::MeasuredCurve curve;
  curve.name = name;
  curve.title = std::string(1, static_cast<char>(std::toupper(column.long_name[0]))) + (column.long_name + 1);
  curve.caption = "Against the distance of the mean planes of the undeformed surfaces.";
  curve.x_axis = {"separation", "separation", "m", "um"};
  curve.y_axis = {column.name, column.long_name, column.unit, column.display_unit};
  io::MeasuredSeries series{column.name, column.long_name, {}, false};
  for (const Point& point : points) {
    curve.x.push_back(point.mean.separation_m);
    series.y.push_back(column.value(point));
  }
  curve.series.push_back(std::move(series));
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

constexpr double kFewSpots = 5;  // on all maps of a law: fewer are one sample

/// Beyond it a law is an extrapolation; the smallest separation where nowhere enough spots carry [m].
double last_supported(const surface::ContactLaw& law, double positions) {
  const double area = static_cast<double>(law.grid.points()) * law.grid.step_x_m * law.grid.step_y_m * positions;
  double last = 0, smallest = std::numeric_limits<double>::max();
  for (const Point& point : law.points) {
    smallest = std::min(smallest, point.mean.separation_m);
    if (point.mean.spots_per_m2 * area >= kFewSpots) last = std::max(last, point.mean.separation_m);
  }
  return last > 0 ? last : smallest;
}

io::MeasuredGroup law_group(const surface::ContactLaw& law, const ContactAnalysis& analysis) {
  io::MeasuredGroup group{"The pair in contact", {}};
  const auto add = [&](const char* name, const char* words, const char* symbol, const char* unit, const char* display,
                       double value) {
    group.values.push_back(value_of(name, words, symbol, unit, display, value, ""));
  };
  double residual = 0, iterations = 0;
  for (const Point& point : law.points) {
    residual = std::max(residual, point.mean.residual);
    iterations += point.mean.iterations;
  }
  add("composite_roughness", "rms height of the sum of both surfaces", "Sq", "m", "um", law.Sq_m);
  add("highest_point", "highest point of the sum above its mean plane", "", "m", "um", law.highest_m);
  add("composite_modulus", "composite modulus", "E'", "Pa", "GPa", 2 * analysis.material.E_star);
  if (analysis.material.hardness) {
    add("hardness", "hardness of the softer face", "H", "Pa", "GPa", *analysis.material.hardness);
  }
  add("relative_positions", "relative positions of both surfaces", "", "1", "1", static_cast<double>(analysis.shifts));
  add("missing_share", "share of the points without a height", "", "1", "%", law.missing_share);
  add(io::kLastSupportedSeparation, "largest separation at which five spots of a map or more carry", "", "m", "um",
      last_supported(law, static_cast<double>(analysis.shifts)));
  add("complementarity_residual", "largest rms violation of the complementarity over Sq", "", "1", "1", residual);
  add("iterations", "iterations of the conjugate gradients", "", "1", "1", iterations);
  return group;
}

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
  const double slope = std::hypot(rms_slope(pair.first), pair.second ? rms_slope(*pair.second) : 0.0);
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

}  // namespace

io::Measurement contact_measurement(const SurfaceFile& first, const SurfaceFile* second,
                                    const ContactAnalysis& analysis) {
  io::Measurement all;
  all.kind = io::kContactLawKind;
  const PreparedSurface one = prepared(first, analysis, all.notes);
  std::optional<PreparedSurface> other;
  if (second != nullptr) other = prepared(*second, analysis, all.notes);
  all.title = "Contact law of " + file_name(one.origin.path) + " with " +
              (other ? file_name(other->origin.path) : std::string("a smooth flat"));
  all.sources = source_lines(one);
  if (other) {
    for (std::string& line : source_lines(*other)) all.sources.push_back(std::move(line));
  }
  all.statements = statements_of(analysis, one);

  surface::SurfacePair pair{one.map, {}, analysis.edges, analysis.material, analysis.shifts, analysis.has_flow};
  if (other) pair.second = other->map;
  const std::vector<double> separations =
      analysis.separations_m.empty() ? surface::usual_separations(pair) : analysis.separations_m;
  const surface::ContactLaw law = surface::contact_law(pair, separations);

  for (std::string& note : law_notes(pair, law)) all.notes.push_back(std::move(note));
  all.groups.push_back(law_group(law, analysis));
  all.tables.push_back(law_table(law, analysis));
  all.curves.push_back(law_curve(law, kColumns[1], "pressure_curve"));
  all.curves.push_back(law_curve(law, kColumns[2], "area_curve"));
  if (analysis.has_flow) {
    for (const Column& column : {kFlowColumns[0], kFlowColumns[1], kFlowColumns[2]}) {
      all.curves.push_back(law_curve(law, column, std::string(column.name) + "_curve"));
    }
  }
  if (!pair.first.is_profile()) all.maps.push_back(pressure_map(law));
  return all;
}

}  // namespace ringfilm::instrument
