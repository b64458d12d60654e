#include "ringfilm/instrument/documents/face_measurement.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "ringfilm/base/error.hpp"
#include "ringfilm/instrument/documents/surface_values.hpp"
#include "ringfilm/io/case/contact_fragment.hpp"

namespace ringfilm::instrument {
namespace {

using surface::FaceDirection;
using surface::FaceFit;
using surface::FaceLevelling;
using surface::FaceRule;
using surface::FaceZero;
using surface::HeightSense;

constexpr double kFlatShare = 0.25;    // least flat share of a running surface that is not round
constexpr double kManyPores = 0.3;     // a sprayed face of styles2014 has 0.15
constexpr double kEdgeMoved_m = 1e-7;  // as fine as anyone reads the height of an edge

std::string micrometres(double length_m) { return text_in(length_m, kMicrometre, 4); }

const char* reason_text(surface::InventionReason reason) {
  switch (reason) {
    case surface::InventionReason::kDeparts:
      return "lies off the trace";
    case surface::InventionReason::kTurnNotInTrace:
      return "turns where the trace does not";
    case surface::InventionReason::kFallsTowardsTheEdge:
      return "falls towards the edge, with the trace";
  }
  return "";
}

std::string levelling_text(const FaceRule& rule, const FaceFit& fit) {
  const std::string tilt = text_in(fit.tilt, kMilliradian);
  switch (rule.levelling) {
    case FaceLevelling::kNone:
      return "tilt left as measured";
    case FaceLevelling::kStated:
      return "the stated tilt of " + tilt + " was removed";
    case FaceLevelling::kRunningSurface:
      return fmt::format("the running surface was made level, at most {} above the lowest point: {} removed",
                         micrometres(rule.running_surface_height_m), tilt);
  }
  return "";
}

std::vector<std::string> source_lines(const TraceFile& file) {
  const SurfaceOrigin& origin = file.origin;
  return origin_lines(origin, fmt::format(", channel {} ({})", origin.channel_number, origin.channel),
                      file.plausibility_line);
}

std::vector<std::string> statement_lines(const FaceRule& rule, const FaceFit& fit) {
  std::vector<std::string> lines;
  lines.push_back(rule.sense == HeightSense::kMaterial
                      ? "heights count away from the ring and were turned into the gap to a straight liner"
                      : "heights are the gap to a straight liner");
  lines.push_back(fmt::format("the face of {} starts {} in the trace, {}", text_in(rule.width_m, kMillimetre),
                              text_in(fit.start_m, kMillimetre),
                              rule.start_m ? "as stated" : "where its mean gap is least"));
  if (rule.direction == FaceDirection::kTurned) lines.push_back("turned about: x = 0 is the end of the trace");
  if (fit.averaged > 1) lines.push_back(fmt::format("{} neighbouring points were averaged into one", fit.averaged));
  if (rule.pore_depth_m) {
    lines.push_back(fmt::format("points deeper than the spline by more than {} were omitted as pores",
                                micrometres(*rule.pore_depth_m)));
  }
  lines.push_back(levelling_text(rule, fit));
  lines.push_back(rule.zero == FaceZero::kMinPoint ? "zero is the lowest point of the spline"
                                                   : "heights keep their zero as measured");
  lines.push_back(
      fmt::format("polynomial of degree {} by least squares over the length; smoothing spline that passes "
                  "half of a wave of {}",
                  rule.degree, micrometres(fit.spline_cutoff_m)));
  return lines;
}

/// The tilt that comes off with a running surface of half and of twice the height: a flat running surface gives the
/// same. NaN where such a running surface cannot be made level.
struct OtherTilts {
  double lower, higher;
  double edge_m;  ///< by which an edge moves between the three, at most
  /// Width of the flat part: the running surface of height h is flat + k sqrt(h) wide between flanks that begin as
  /// parabolas.
  double flat_m;
};

std::optional<OtherTilts> other_tilts(const surface::Trace& trace, const FaceRule& rule, const FaceFit& fit) {
  if (rule.levelling != FaceLevelling::kRunningSurface) return std::nullopt;
  struct RunningSurface {
    double tilt = std::nan(""), width_m = std::nan("");
  };
  const auto running_surface = [&](double factor) {
    FaceRule other = rule;
    other.running_surface_height_m *= factor;
    try {
      const FaceFit of = surface::fit_face(trace, other);
      return RunningSurface{of.tilt, of.running_surface_to_m - of.running_surface_from_m};
    } catch (const InputError&) {
      return RunningSurface{};
    }
  };
  const RunningSurface low = running_surface(0.5), high = running_surface(2);
  const double most = std::fmax(fit.tilt, std::fmax(low.tilt, high.tilt));
  const double least = std::fmin(fit.tilt, std::fmin(low.tilt, high.tilt));
  return OtherTilts{low.tilt, high.tilt, (most - least) * rule.width_m, 2 * low.width_m - high.width_m};
}

/// "running surfaces of 0.5 um, 1 um, 2 um above the lowest point remove 1, 1.2, none mrad of tilt".
std::string tilts_text(const FaceRule& rule, const FaceFit& fit, const OtherTilts& tilts) {
  std::string heights, angles;
  for (const auto& [factor, tilt] :
       {std::pair(0.5, tilts.lower), std::pair(1.0, fit.tilt), std::pair(2.0, tilts.higher)}) {
    if (!heights.empty()) heights += ", ";
    heights += micrometres(factor * rule.running_surface_height_m);
    if (!angles.empty()) angles += ", ";
    angles += std::isnan(tilt) ? "none that can be found" : number_text(number_in(tilt, kMilliradian), 3);
  }
  return "running surfaces of " + heights + " above the lowest point remove " + angles + " mrad of tilt";
}

io::MeasuredGroup face_group(const FaceRule& rule, const FaceFit& fit, const std::optional<OtherTilts>& tilts) {
  Group group("The face");
  group.add("face_width", "width of the face", "b", "m", "mm", rule.width_m);
  group.add("face_start", "where it begins in the trace", "start", "m", "mm", fit.start_m);
  group.add("tilt", "tilt removed", "", "rad", "mrad", fit.tilt);
  if (tilts) {
    group.add("tilt_half_running_surface", "tilt with a running surface of half the height", "", "rad", "mrad",
              tilts->lower);
    group.add("tilt_double_running_surface", "tilt with a running surface of twice the height", "", "rad", "mrad",
              tilts->higher);
  }
  const std::string running_surface =
      "at most " + micrometres(rule.running_surface_height_m) + " above the lowest point";
  group.add("running_surface_from", "beginning of the running surface", "running surface from", "m", "mm",
            fit.running_surface_from_m, running_surface);
  group.add("running_surface_to", "end of the running surface", "running surface to", "m", "mm",
            fit.running_surface_to_m, running_surface);
  group.add("running_surface_width", "width of the running surface", "running surface", "m", "mm",
            fit.running_surface_to_m - fit.running_surface_from_m, running_surface);
  group.add("points", "points of the trace in the face", "", "1", "1", static_cast<double>(fit.x_m.size()));
  if (rule.pore_depth_m) group.add("pore_share", "points omitted as pores", "", "1", "%", fit.pore_share);
  group.add("noise", "rms of what neither polynomial nor spline follows", "", "m", "um", fit.noise_m);
  return group;
}

/// Minimum, edges and residual of a fit, whose names begin with `name`.
void add_fit(const std::string& name, double minimum_m, double minimum_at_m, const double (&end_m)[2],
             const surface::FaceResidual& residual, Group& group) {
  group.add(name + "_minimum", "least gap", "minimum", "m", "um", minimum_m);
  group.add(name + "_minimum_at", "where", "at", "m", "mm", minimum_at_m);
  group.add(name + "_end_0", "height of the edge x = 0", "edge x = 0", "m", "um", end_m[0], "above the least");
  group.add(name + "_end_b", "height of the edge x = b", "edge x = b", "m", "um", end_m[1], "above the least");
  group.add(name + "_residual_rms", "rms of trace less " + name, "residual rms", "m", "um", residual.rms_m);
  group.add(name + "_residual_largest", "largest of them", "largest", "m", "um", residual.largest_m,
            "at x = " + text_in(residual.largest_at_m, kMillimetre));
}

io::MeasuredGroup polynomial_group(const FaceRule& rule, const FaceFit& fit) {
  Group group(fmt::format("Polynomial of degree {}", rule.degree));
  add_fit("polynomial", fit.polynomial_minimum_m, fit.polynomial_minimum_at_m, fit.polynomial_end_m,
          fit.polynomial_residual, group);
  return group;
}

io::MeasuredGroup spline_group(const FaceFit& fit) {
  Group group("Smoothing spline");
  group.add("spline_cutoff", "wave of which half passes", "cut-off", "m", "um", fit.spline_cutoff_m);
  add_fit("spline", fit.spline_minimum_m, fit.spline_minimum_at_m, fit.spline_end_m, fit.spline_residual, group);
  return group;
}

/// In the units of Table 4 of styles2014: x in mm, heights in um.
io::MeasuredGroup coefficient_group(const FaceFit& fit) {
  Group group("Coefficients, x in mm and gap in um, highest power first (8 digits are in the fragment)");
  const std::vector<double>& coefficients = fit.polynomial.coefficients_mm_um();
  const int degree = static_cast<int>(coefficients.size()) - 1;
  for (int k = 0; k <= degree; ++k) {
    const int power = degree - k;
    const std::string letter(1, static_cast<char>('a' + k));
    const std::string unit = power == 0 ? "m" : power == 1 ? "1" : fmt::format("m{}", 1 - power);
    const std::string display = power == 0 ? "um" : fmt::format("um mm-{}", power);
    const double in_si = 1e-6 * coefficients[static_cast<std::size_t>(k)] * std::pow(1e3, power);
    group.add("coefficient_" + letter, fmt::format("of x^{}", power), letter, unit, display, in_si);
  }
  return group;
}

io::MeasuredTable invention_table(const FaceFit& fit) {
  io::MeasuredTable table{"fit_artifact", "Where the polynomial invents shape", {}, {}, {}};
  add_column(table, "invented_from", "from", "from", "m", "mm");
  add_column(table, "invented_to", "to", "to", "m", "mm");
  add_column(table, "invented_size", "largest distance, or fall", "size", "m", "um");
  for (const surface::FitArtifact& shape : fit.invented) {
    add_row(table, reason_text(shape.reason), {shape.from_m, shape.to_m, shape.size_m});
  }
  return table;
}

std::vector<double> polynomial_at_points(const FaceFit& fit) {
  std::vector<double> heights;
  for (const double x : fit.x_m) heights.push_back(fit.polynomial.height_m(x));
  return heights;
}

io::MeasuredCurve face_curve(const FaceFit& fit) {
  io::MeasuredCurve curve =
      curve_of("face", "Face of the ring",
               "The gap between the face and a straight liner: the trace after levelling, and both fits. The case "
               "takes one of the fits.",
               {"x", "distance along the face", "m", "mm"}, {"gap", "gap to a straight liner", "m", "um"});
  curve.x = fit.x_m;
  curve.series = {{"trace", "trace (measured)", fit.gap_m},
                  {"polynomial", "polynomial", polynomial_at_points(fit)},
                  {"spline", "smoothing spline", fit.spline_m}};
  curve.marks = {{fit.running_surface_from_m, "running surface from"},
                 {fit.running_surface_to_m, "running surface to"}};
  return curve;
}

io::MeasuredCurve residual_curve(const FaceFit& fit) {
  io::MeasuredCurve curve =
      curve_of("residuals", "Residuals of the fits",
               "Trace less fit. Noise lies about zero without a pattern; a pattern is shape that the fit does not "
               "have, or has too much. Upright lines: where invented shape begins and ends.",
               {"x", "distance along the face", "m", "mm"}, {"residual", "trace less fit", "m", "um"});
  curve.x = fit.x_m;
  std::vector<double> of_polynomial, of_spline;
  const std::vector<double> polynomial = polynomial_at_points(fit);
  for (std::size_t i = 0; i < fit.x_m.size(); ++i) {
    of_polynomial.push_back(fit.gap_m[i] - polynomial[i]);
    of_spline.push_back(fit.gap_m[i] - fit.spline_m[i]);
  }
  curve.series = {{"polynomial_residual", "trace less polynomial", std::move(of_polynomial)},
                  {"spline_residual", "trace less spline", std::move(of_spline)}};
  for (const surface::FitArtifact& shape : fit.invented) {
    curve.marks.push_back({shape.from_m, "invented from"});
    curve.marks.push_back({shape.to_m, "to"});
  }
  return curve;
}

constexpr double kManyNoises = 8;  // multiple of the noise that a residual hardly reaches by noise alone

std::vector<std::string> note_lines(const FaceRule& rule, const FaceFit& fit, const std::optional<OtherTilts>& tilts) {
  std::vector<std::string> notes;
  if (tilts && (tilts->edge_m > kEdgeMoved_m || std::isnan(tilts->lower) || std::isnan(tilts->higher))) {
    notes.push_back(fmt::format(
        "the running surface is not flat, and its level depends on where it ends: {}, {} from edge to edge; "
        "where the tilt of the holder is known, state it with --tilt",
        tilts_text(rule, fit, *tilts), micrometres(tilts->edge_m)));
  }
  const double land_m = fit.running_surface_to_m - fit.running_surface_from_m;
  if (tilts && tilts->flat_m < kFlatShare * land_m) {
    notes.push_back(
        fmt::format("the running surface is round: hardly any of its {} is flat. A round running surface is as round "
                    "when it is tilted, so "
                    "that making it level does not find the tilt of the holder; state that tilt with --tilt, or leave "
                    "the trace as measured with --levelling none",
                    text_in(land_m, kMillimetre)));
  }
  bool of_its_own = false;
  for (const surface::FitArtifact& shape : fit.invented) {
    const bool with_trace = shape.reason == surface::InventionReason::kFallsTowardsTheEdge;
    notes.push_back("polynomial, " + shape.words() +
                    (with_trace ? "; wear against a straight liner does not do that" : ""));
    of_its_own = of_its_own || !with_trace;
  }
  const bool stiff = std::abs(fit.spline_residual.largest_m) > kManyNoises * fit.noise_m;
  if (stiff) {
    notes.push_back(
        fmt::format("the spline misses the trace by {} at x = {}: it ends straight, and the face does not; "
                    "--spline-cutoff below {} "
                    "lets it follow",
                    micrometres(fit.spline_residual.largest_m), text_in(fit.spline_residual.largest_at_m, kMillimetre),
                    micrometres(fit.spline_cutoff_m)));
  }
  if (of_its_own && !stiff) {
    notes.push_back("the spline follows the trace where the polynomial does not: a case takes it with --as points");
  }
  if (fit.pore_share > kManyPores) {
    notes.push_back(
        fmt::format("{:.3g} % of the points were omitted as pores; is the stated depth below the roughness?",
                    100 * fit.pore_share));
  }
  if (rule.levelling == FaceLevelling::kNone) {
    notes.push_back("tilt was left in: the holder's tilt is then part of the face");
  }
  notes.push_back(
      fmt::format("the case needs ring.face_width = \"{}\", and states with ring.face.orientation which edge "
                  "x = 0 is: the trace does not show it",
                  text_in(rule.width_m, kMillimetre)));
  return notes;
}

std::vector<std::string> heading_lines(const TraceFile& file, const FaceRule& rule) {
  std::vector<std::string> lines = {
      "Face of a ring from " + file_name(file.origin.path) + " (SHA-256 " + file.origin.sha256 + ")",
      "ring.face_width is " + text_in(rule.width_m, kMillimetre)};
  for (const std::string& doubt : file.origin.doubts) lines.push_back("note: " + doubt);
  return lines;
}

}  // namespace

io::Measurement face_measurement(const TraceFile& file, const FaceRule& rule, const FaceFit& fit,
                                 const std::optional<std::string>& points_file) {
  const std::string trace_name = file_name(file.origin.path);
  io::Measurement all;
  all.kind = "face";
  all.title = "Ring face " + trace_name;
  all.sources = source_lines(file);
  all.statements = statement_lines(rule, fit);
  const std::optional<OtherTilts> tilts = other_tilts(file.trace, rule, fit);
  all.notes = file.origin.doubts;
  for (std::string& note : note_lines(rule, fit, tilts)) all.notes.push_back(std::move(note));
  all.key_values = {"running_surface_width", "polynomial_residual_rms", "noise"};
  all.groups = {face_group(rule, fit, tilts), polynomial_group(rule, fit), spline_group(fit), coefficient_group(fit)};
  if (!fit.invented.empty()) all.tables.push_back(invention_table(fit));
  all.curves = {face_curve(fit), residual_curve(fit)};
  const std::vector<std::string> heading = heading_lines(file, rule);
  all.fragment = points_file ? io::face_points_fragment(fit, rule, trace_name, *points_file, heading)
                             : io::face_polynomial_fragment(fit, rule, trace_name, heading);
  return all;
}

}  // namespace ringfilm::instrument
