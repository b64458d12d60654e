#include "ringfilm/instrument/documents/land_measurement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "ringfilm/base/error.hpp"
#include "ringfilm/instrument/documents/surface_values.hpp"
#include "ringfilm/io/measurement/land_law_file.hpp"
#include "ringfilm/models/land/land_lift.hpp"
#include "ringfilm/pad/land_film.hpp"

namespace ringfilm::instrument {
namespace {

constexpr double kThinLandGap = 0.02e-6;  // lowest gap below which surfaces touch in truth (assumed) [m]

using LandPoint = pad::LandFilmPoint;

/// A column of the table; `of` what it is divided by, eta U/separation where it is a factor.
struct LandColumn {
  const char *name, *long_name, *symbol, *unit, *display_unit;
  double LandPoint::*value;
};

constexpr LandColumn kLandTableColumns[] = {
    {"separation", "distance of the mean planes", "s", "m", "um", &LandPoint::separation},
    {"lift", "mean film pressure above ambient over the land", "p_l", "Pa", "kPa", &LandPoint::lift},
    {"lift_scatter", "standard deviation of the lift over patches", "s(p_l)", "Pa", "kPa", &LandPoint::lift_scatter},
    {"friction_stress", "mean shear stress on the land", "tau", "Pa", "kPa", &LandPoint::friction_stress},
    {"friction_scatter", "standard deviation of the shear stress over patches", "s(tau)", "Pa", "kPa",
     &LandPoint::friction_scatter},
    {"mean_gap", "mean film thickness over the patches", "<h>", "m", "um", &LandPoint::mean_gap},
    {"lowest_gap", "lowest film thickness of all patches", "h_min", "m", "um", &LandPoint::lowest_gap},
    {"flow", "oil that passes, as a film that moves with the speed", "q/U", "m", "um", &LandPoint::flow},
    {"cavitated_fraction", "cavitated share of the land", "", "1", "%", &LandPoint::cavitated_fraction},
};

io::MeasuredTable land_table(const pad::LandFilm& film, const LandAnalysis& analysis) {
  io::MeasuredTable table{io::kLandLawTable, "Film of the land", {}, {}, {}};
  for (const LandColumn& column : kLandTableColumns) {
    std::vector<double>& rows =
        add_column(table, column.name, column.long_name, column.symbol, column.unit, column.display_unit);
    for (const LandPoint& point : film.points) rows.push_back(point.*column.value);
  }
  std::vector<double>& factor =
      add_column(table, "friction_factor", "shear stress over that of a smooth film of the separation", "f", "1", "1");
  for (const LandPoint& point : film.points) {
    factor.push_back(point.friction_stress * point.separation / (analysis.viscosity * analysis.speed));
  }
  return table;
}

/// Mean exponent of the speed over the rows that have one; 1 without.
double speed_exponent(const pad::LandFilm& film) {
  constexpr double kMin = 0.5, kMax = 2;
  double sum = 0, n = 0;
  for (const LandPoint& point : film.points) {
    if (!(point.lift > 0) || std::isnan(point.speed_exponent)) continue;
    sum += point.speed_exponent;
    n += 1;
  }
  return n > 0 ? std::clamp(sum / n, kMin, kMax) : 1;
}

double log_lift_deviation(const pad::LandFilm& film) {
  std::vector<double> lift, scatter;
  for (const LandPoint& point : film.points) {
    lift.push_back(point.lift);
    scatter.push_back(point.lift_scatter);
  }
  return io::log_lift_deviation(lift, scatter);
}

io::MeasuredGroup land_group(const pad::LandFilm& film, const LandAnalysis& analysis) {
  Group group("Land and film");
  group.add("land_width", "width of the land along the motion", "w", "m", "mm", analysis.width);
  group.add("speed", "sliding speed", "U", "m s-1", "m/s", analysis.speed);
  group.add("viscosity", "viscosity of the oil", "eta", "Pa s", "mPa s", analysis.viscosity);
  group.add("ambient_pressure", "pressure at both edges, absolute", "", "Pa", "bar", analysis.ambient_pressure);
  group.add("cavitation_pressure", "pressure of cavities, absolute", "p_c", "Pa", "bar", analysis.cavitation_pressure);
  group.add("roughness", "rms height of the surfaces", "Sq", "m", "um", film.roughness);
  group.add("highest_point", "highest point above the mean plane", "", "m", "um", film.highest);
  group.add("patches", "patches of the map", "", "1", "1", film.patches);
  group.add("patch_length", "length of a patch across the motion", "", "m", "mm", film.patch_length);
  group.add("cells_along", "cells along the motion", "", "1", "1", film.cells_along);
  group.add("cells_across", "cells across the motion", "", "1", "1", film.cells_across);
  group.add("speed_exponent", "lift over the product of viscosity and speed to this power", "m", "1", "1",
            speed_exponent(film));
  if (film.patches > 1) {
    group.add(io::kLogLiftDeviation, "standard deviation of the logarithm of the lift over patches", "s(ln p_l)", "1",
              "%", log_lift_deviation(film));
  }
  return group;
}

models::LandFit fit_of(const pad::LandFilm& film, const LandAnalysis& analysis) {
  std::vector<double> separation, lift;
  for (const LandPoint& point : film.points) {
    separation.push_back(point.separation);
    lift.push_back(point.lift);
  }
  return models::fit_land(separation, lift, film.roughness, analysis.width, analysis.speed * analysis.viscosity);
}

io::MeasuredGroup fit_group(const models::LandFit& fit) {
  Group group("Fit: lift Sq^2/(eta U w) = a (separation/Sq)^-n");
  group.add("fit_coefficient", "coefficient", "a", "1", "1", fit.coefficient);
  group.add("fit_exponent", "exponent", "n", "1", "1", fit.exponent);
  group.add("fit_residual", "rms residual of the logarithm of the lift", "", "1", "%", fit.residual);
  return group;
}

io::MeasuredCurve lift_curve(const pad::LandFilm& film) {
  io::MeasuredCurve curve =
      curve_of("lift_curve", "Lift of the land", "Mean film pressure above ambient, with one standard deviation.",
               {"separation", "distance of the mean planes", "m", "um"},
               {"lift", "mean film pressure above ambient", "Pa", "kPa"});
  std::vector<LandPoint> points = film.points;
  std::stable_sort(points.begin(), points.end(),
                   [](const LandPoint& a, const LandPoint& b) { return a.separation < b.separation; });
  const bool has_scatter = film.patches > 1;
  const std::pair<const char*, const char*> bands[] = {
      {"lift", "lift"}, {"lower", "less one standard deviation"}, {"upper", "plus one standard deviation"}};
  for (const LandPoint& point : points) curve.x.push_back(point.separation);
  for (int k = 0; k < (has_scatter ? 3 : 1); ++k) {
    io::MeasuredSeries series{bands[k].first, bands[k].second, {}, false};
    const double sign = k == 0 ? 0 : (k == 1 ? -1 : 1);
    for (const LandPoint& point : points) series.y.push_back(point.lift + sign * point.lift_scatter);
    curve.series.push_back(std::move(series));
  }
  return curve;
}

std::vector<std::string> land_notes(const pad::LandFilm& film, const LandAnalysis& analysis, bool has_land_map) {
  std::vector<std::string> notes;
  if (film.patches == 1) notes.push_back("one patch is one sample: a larger map gives the scatter of the lift");
  for (const LandPoint& point : film.points) {
    if (point.lowest_gap >= kThinLandGap) continue;
    notes.push_back(
        fmt::format("at a separation of {} the lowest gap is {}: contact, which this film does not have, "
                    "carries there as well",
                    surface::length_text(point.separation), surface::length_text(point.lowest_gap)));
  }
  const bool sinks =
      std::any_of(film.points.begin(), film.points.end(), [](const LandPoint& p) { return p.lift <= 0; });
  if (sinks) notes.push_back("without lift at some separations: cavities do not hold the film up there");
  if (has_land_map) {
    notes.push_back("the film is that of a smooth land over the sum of both maps: the scan of the land rests");
  }
  if (analysis.cavitation_pressure == analysis.ambient_pressure) {
    notes.push_back("cavities have the pressure of the edges: every wave lifts, and the lift is an upper bound");
  }
  return notes;
}

}  // namespace

io::Measurement land_measurement(const SurfaceFile& liner, const SurfaceFile* land, const LandAnalysis& analysis) {
  io::Measurement all;
  all.kind = io::kLandLawKind;
  all.title = "Film of a land on " + file_name(liner.origin.path);
  add_doubts(&liner, all.notes);
  add_doubts(land, all.notes);
  SurfaceAnalysis alone;
  alone.preparation = analysis.preparation;
  const PreparedSurface first = prepare_surface(liner, alone);
  all.sources = source_lines(first);
  pad::LandFilmProblem problem;
  problem.surface = first.map;
  if (land != nullptr) {
    const PreparedSurface second = prepare_surface(*land, alone);
    for (std::string& line : source_lines(second)) all.sources.push_back(std::move(line));
    problem.surface = surface::sum_of_surfaces(first.map, second.map, analysis.edges);
  }
  const bool repeats = analysis.edges == surface::MapEdges::periodic;
  problem.width = analysis.width;
  problem.speed = analysis.speed;
  problem.viscosity = analysis.viscosity;
  problem.ambient_pressure = analysis.ambient_pressure;
  problem.cavitation_pressure = analysis.cavitation_pressure;
  problem.sides = repeats ? film::Ends::kJoined : film::Ends::kClosed;
  problem.patches = analysis.patches;
  problem.separations = analysis.separations_m;
  const pad::LandFilm film = pad::land_film(problem);

  all.statements = first.prepared.lines();
  all.statements.push_back("separation: distance of the mean planes; motion along the rows of the maps");
  all.statements.push_back(repeats ? "across the motion the map repeats (periodic)"
                                   : "across the motion a patch continues by its mirror images");
  all.statements.push_back("steady, mass-conserving film of a smooth land that slides over the rough liner");
  for (std::string& note : land_notes(film, analysis, land != nullptr)) all.notes.push_back(std::move(note));
  all.groups.push_back(land_group(film, analysis));
  const models::LandFit fit = fit_of(film, analysis);
  if (fit.rows > 1) all.groups.push_back(fit_group(fit));
  all.key_values = {"land_width", "roughness", "highest_point"};
  all.tables.push_back(land_table(film, analysis));
  all.curves.push_back(lift_curve(film));
  return all;
}

}  // namespace ringfilm::instrument
