#include "ringfilm/instrument/documents/conformity.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "ringfilm/base/display.hpp"
#include "ringfilm/instrument/documents/surface_values.hpp"
#include "ringfilm/io/measurement/section_numbers.hpp"

namespace ringfilm::instrument {
namespace {

using std::numbers::pi;

double degrees(double angle) { return number_in(angle, kDegree); }

/// Whole degrees and both ends of the ring [rad].
std::vector<double> places(const models::RingClosure& ring) {
  const double start = ring.ring().start(), end = ring.ring().end();
  std::vector<double> all{start};
  for (int i = 0; i <= 360; ++i) {
    const double phi = i * pi / 180;
    if (phi > start && phi < end) all.push_back(phi);
  }
  all.push_back(end);
  return all;
}

void append_arcs(const models::RingClosure& ring, io::Measurement& all) {
  io::MeasuredTable arcs{kContactArcs, "Contact arcs", {}, {}, {}};
  add_column(arcs, "from", "start of the arc from the middle of the gap", "phi_a", "degree", "degree");
  add_column(arcs, "to", "end of the arc", "phi_b", "degree", "degree");
  for (const models::ContactArc& arc : ring.arcs()) add_row(arcs, {degrees(arc.from), degrees(arc.to)});
  io::MeasuredTable points{kContactPoints, "Contacts in a point", {}, {}, {}};
  add_column(points, "angle", "angle from the middle of the gap", "phi", "degree", "degree");
  for (const models::ContactArc& point : ring.points()) add_row(points, {degrees(point.from)});
  io::MeasuredTable forces{kPointForces, "Point forces of the wall", {}, {}, {}};
  add_column(forces, "angle", "angle from the middle of the gap", "phi", "degree", "degree");
  add_column(forces, "force", "force of the wall, inwards", "P", "N", "N");
  for (const models::PointForce& one : ring.point_forces()) add_row(forces, {degrees(one.phi), one.force});
  io::MeasuredTable orders{kPressureOrders, "Orders of the target pressure", {}, {}, {}};
  add_column(orders, "order", "periods around the ring", "n", "1", "1");
  add_column(orders, "amplitude", "amplitude over the mean pressure", "alpha_n", "1", "1");
  add_column(orders, "phase", "angle of a crest from the middle of the gap", "phi_n", "degree", "degree");
  const models::FourierSeries& target = ring.ring().beam().target_force();
  for (const models::FourierOrder& one : target.orders()) {
    if (one.order < 2) continue;
    const double mean = ring.ring().beam().size().tangential_force;
    add_row(orders, {1.0 * one.order, one.amplitude / mean, degrees(one.phase)});
  }
  for (io::MeasuredTable* table : {&arcs, &points, &forces, &orders}) all.tables.push_back(std::move(*table));
}

struct SeriesAround {
  const char *name, *label;
  std::function<double(double)> value;  ///< over the angle [rad]
};

void append_curve(const models::RingClosure& ring, const char* name, const char* title, const char* caption,
                  const io::MeasuredAxis& axis, const std::vector<SeriesAround>& all_series, io::Measurement& all) {
  io::MeasuredCurve curve =
      curve_of(name, title, caption, {"angle", "angle from the middle of the gap", "degree", "degree"}, axis);
  for (const SeriesAround& series : all_series) curve.series.push_back({series.name, series.label, {}});
  for (const double phi : places(ring)) {
    curve.x.push_back(degrees(phi));
    for (std::size_t i = 0; i < all_series.size(); ++i) curve.series[i].y.push_back(all_series[i].value(phi));
  }
  all.curves.push_back(std::move(curve));
}

void append_curves(const models::RingClosure& ring, io::Measurement& all) {
  const auto bore = [&](double phi) { return ring.ring().bore()(phi); };
  const auto clearance = [&](double phi) { return ring.clearance(phi); };
  append_curve(ring, "clearance_around", "Clearance",
               "clearance between ring and bore around the bore; zero in contact arcs",
               {"clearance", "clearance", "m", "um"}, {{"clearance", "ring to bore", clearance}}, all);
  append_curve(ring, "bore_around", "Bore and ring",
               "deviation of the radius from the nominal one: the bore, and the ring that bends in it",
               {"deviation", "deviation of the radius", "m", "um"},
               {{"bore", "bore", bore}, {"ring", "ring", [&](double phi) { return bore(phi) - clearance(phi); }}}, all);
  append_curve(ring, "force_around", "Force of the wall",
               "force of the wall from the end of the ring on; it jumps by the point forces",
               {"cumulative_force", "force of the wall up to here", "N", "N"},
               {{"cumulative_force", "wall", [&](double phi) { return ring.force_up_to(phi); }}}, all);
  append_curve(
      ring, "moment_around", "Bending moment",
      "bending moment of the ring in the bore, and in a round one; positive closes the ring",
      {"moment", "bending moment", "N m", "N m"},
      {{"moment", "in this bore", [&](double phi) { return ring.moment(phi); }},
       {"target_moment", "in a round bore", [&](double phi) { return ring.ring().beam().target_moment(phi); }}},
      all);
}

/// What was removed of a measured free shape, and how sure the pressure of the rest is.
io::MeasuredGroup free_shape_group(const cycle::Case& c, const models::FreeShapeFit& fit) {
  Group group("Free shape");
  group.add("free_shape_smoothing", "shortest wave around the ring that is kept", "lambda_s", "m", "mm",
            c.ring.free_shape_smoothing);
  group.add("free_shape_orders", "highest order of the target pressure", "N", "1", "1",
            1.0 * fit.pressure_orders.orders().back().order);
  group.add("free_shape_residual", "rms distance of the measured points from the smoothed shape", "d", "m", "um",
            fit.residual);
  group.add("force_deviation", "standard deviation of the tangential force by that scatter, over it", "s_F", "1", "%",
            fit.force_deviation);
  group.add("pressure_deviation", "the same of the target pressure, rms around the ring, over its mean", "s_w", "1",
            "%", fit.pressure_deviation);
  return group;
}

std::string exact(double value) { return fmt::format("{}", value + 0.0); }

}  // namespace

io::Measurement conformity_of_case(const cycle::Case& whole, const cycle::StaticClosure& closure) {
  const cycle::Case& c = whole.rings.empty() ? whole : whole.rings.front();
  io::Measurement all;
  all.kind = "conformity";
  all.title = c.title.empty() ? "Ring in its bore" : c.title;
  for (const cycle::InputFile& file : c.files) all.sources.push_back(file.role + ": " + file.path);
  const models::RingBeam& beam = closure.ring.ring().beam();
  all.statements = {
      "static closure: thin curved beam, rigid wall without friction, small deflections about the closed ring; what "
      "the cycle adds to the bore is zero",
      "angles count from the middle of the gap in the direction of theta",
      fmt::format("target pressure: its mean and its orders, and {:.3g} % of order 1 that balance it on a ring with an "
                  "end gap of {}",
                  100 * beam.projection(), text_in(beam.size().end_gap, kMillimetre, 4))};
  all.notes = closure.notes;
  all.notes.insert(all.notes.begin(), c.notes.begin(), c.notes.end());
  if (!whole.rings.empty()) all.notes.push_back("of the pack the first ring is computed");
  Group group("Closure");
  for (const cycle::ClosureQuantity& one : cycle::closure_quantities()) {
    group.add(one.name, one.long_name, one.symbol, one.unit, one.display_unit, closure.values.*one.value);
  }
  all.groups.push_back(std::move(group));
  if (closure.free_shape) all.groups.push_back(free_shape_group(c, *closure.free_shape));
  if (closure.section) all.groups.push_back(io::section_group(*closure.section));
  all.key_values = {"max_clearance", "open_area", "contact_angle"};
  append_arcs(closure.ring, all);
  append_curves(closure.ring, all);
  return all;
}

std::vector<ClosureColumn> closure_columns(const cycle::StaticClosure& closure) {
  const models::RingClosure& ring = closure.ring;
  std::vector<ClosureColumn> columns = {
      {"angle", "degree", {}},       {"bore", "m", {}},     {"clearance", "m", {}},        {"line_force", "N/rad", {}},
      {"cumulative_force", "N", {}}, {"moment", "N m", {}}, {"target_force", "N/rad", {}}, {"free_angle", "degree", {}},
      {"free_radius", "m", {}}};
  const models::RingBeam& beam = ring.ring().beam();
  const std::vector<models::ShapePoint> free = models::free_shape(beam, places(ring));
  std::size_t i = 0;
  for (const double phi : places(ring)) {
    const models::ShapePoint& point = free[i++];
    const double free_angle = std::fmod(degrees(std::atan2(point.y, point.x)) + 360, 360);
    const double row[] = {degrees(phi),
                          ring.ring().bore()(phi),
                          ring.clearance(phi),
                          ring.line_force(phi),
                          ring.force_up_to(phi),
                          ring.moment(phi),
                          beam.target_force()(phi),
                          free_angle,
                          std::hypot(point.x, point.y)};
    for (std::size_t k = 0; k < columns.size(); ++k) columns[k].values.push_back(row[k]);
  }
  return columns;
}

std::string conformity_csv(const cycle::StaticClosure& closure) {
  const std::vector<ClosureColumn> columns = closure_columns(closure);
  std::string text;
  for (const ClosureColumn& column : columns) {
    text += (text.empty() ? "" : ",") + column.name + " [" + column.unit + "]";
  }
  text += "\n";
  for (std::size_t i = 0; i < columns.front().values.size(); ++i) {
    for (std::size_t k = 0; k < columns.size(); ++k) text += (k > 0 ? "," : "") + exact(columns[k].values[i]);
    text += "\n";
  }
  return text;
}

}  // namespace ringfilm::instrument
