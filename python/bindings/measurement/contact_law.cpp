#include "ringfilm/surface/contact/contact_law.hpp"

#include "measurement/height_maps.hpp"

namespace ringfilm::python {
namespace {

using namespace surface;

const std::map<std::string, MapEdges> kEdges{{"mirrored", MapEdges::mirrored}, {"periodic", MapEdges::periodic}};

py::dict contact_law_of(const GivenNumbers& heights, const GivenStep& step, const GivenNumbers& separations,
                        const GivenNumber& E_prime, const GivenMaybeNumber& hardness, const py::object& second,
                        const GivenText& edges, const Given<kinds::Integer>& shifts, bool flow_factors) {
  SurfacePair pair;
  pair.first = height_map(heights, step);
  if (!second.is_none()) pair.second = height_map({second}, step);
  pair.edges = chosen("edges", edges, kEdges);
  pair.material = {number_of("E_prime", E_prime.value, "Pa") / 2, maybe_number_of("hardness", hardness.value, "Pa")};
  const int positions = integer_of("shifts", shifts.value);
  if (positions < 1) throw InputError("shifts = " + std::to_string(positions) + " is below 1");
  pair.shifts = static_cast<std::size_t>(positions);
  pair.has_flow = flow_factors;
  const std::vector<double> at = row_of("separations", separations.value);
  if (at.empty()) throw InputError("separations is empty", "state one separation or more [m]");
  const ContactLaw law = contact_law(pair, at);
  py::dict of;
  const auto put = [&](const char* name, const auto& value) {
    std::vector<double> values;
    for (const ContactLawPoint& point : law.points) values.push_back(value(point));
    of[name] = array_of(values);
  };
  using Point = ContactLawPoint;
  put("separation", [](const Point& point) { return point.mean.separation_m; });
  put("contact_pressure", [](const Point& point) { return point.mean.pressure; });
  put("real_area", [](const Point& point) { return point.mean.area_share; });
  put("mean_gap", [](const Point& point) { return point.mean.mean_gap_m; });
  put("share_at_cap", [](const Point& point) { return point.mean.share_at_cap; });
  put("spot_radius", [](const Point& point) { return point.mean.spot_radius_m; });
  if (positions > 1) put("contact_pressure_deviation", [](const Point& point) { return point.pressure_deviation; });
  put("residual", [](const Point& point) { return point.mean.residual; });
  if (!flow_factors) return of;
  put("phi_x", [](const Point& point) { return point.flow.phi_x; });
  put("phi_y", [](const Point& point) { return point.flow.phi_y; });
  put("phi_s", [](const Point& point) { return point.flow.phi_s; });
  put("phi_fp", [](const Point& point) { return point.flow.phi_fp; });
  return of;
}

}  // namespace

void bind_contact_law(py::module_& part) {
  part.def("contact_law", &contact_law_of, py::arg("heights"), py::arg("step"), py::arg("separations"),
           py::arg("E_prime"), py::arg("hardness") = py::none(), py::arg("second") = py::none(),
           py::arg("edges") = "mirrored", py::arg("shifts") = 1, py::arg("flow_factors") = false,
           R"(Contact of two measured surfaces, or of one with a smooth flat, at stated separations.

heights, second: levelled maps of shape (y, x) [m], NaN where nothing was measured; second None: a flat. step: [m].
separations: distances of the mean planes of the undeformed maps [m]. E_prime: 2 E* [Pa]. hardness: of the softer
face [Pa]; None: elastic. edges: "mirrored" or "periodic". shifts: relative positions, of which the law is the mean.
flow_factors: phi_x, phi_y, phi_s, phi_fp of the true gap, too, and separations beyond the highest point.

Returns a dict of arrays: separation, contact_pressure, real_area, mean_gap, share_at_cap, spot_radius,
contact_pressure_deviation (with shifts above 1), residual. Raises InputError, ConvergenceError, TypeError.
Source: docs/theory, eq-contact-problem.)");
}

}  // namespace ringfilm::python
