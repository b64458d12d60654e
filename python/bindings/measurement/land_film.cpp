#include "ringfilm/pad/land_film.hpp"

#include "measurement/height_maps.hpp"

namespace ringfilm::python {
namespace {

const std::map<std::string, film::Ends> kSidesOfPatch{{"mirrored", film::Ends::kClosed},
                                                      {"periodic", film::Ends::kJoined}};

py::dict land_film_of(const GivenNumbers& heights, const GivenStep& step, const GivenNumbers& separations,
                      const GivenNumber& width, const GivenNumber& speed, const GivenNumber& viscosity,
                      const GivenText& edges, const Given<kinds::Integer>& patches, const GivenNumber& ambient_pressure,
                      const GivenNumber& cavitation_pressure) {
  pad::LandFilmProblem land;
  land.surface = height_map(heights, step);
  land.separations = row_of("separations", separations.value);
  if (land.separations.empty()) throw InputError("separations is empty", "state one separation or more [m]");
  const auto above_zero = [](const char* name, double value) {
    if (!(value > 0)) throw InputError(std::string(name) + " is not above 0");
    return value;
  };
  land.width = above_zero("width", number_of("width", width.value, "m"));
  land.speed = above_zero("speed", number_of("speed", speed.value, "m/s"));
  land.viscosity = above_zero("viscosity", number_of("viscosity", viscosity.value, "Pa s"));
  land.sides = chosen("edges", edges, kSidesOfPatch);
  land.patches = integer_of("patches", patches.value);
  if (land.patches < 1) throw InputError("patches = " + std::to_string(land.patches) + " is below 1");
  land.ambient_pressure = above_zero("ambient_pressure", number_of("ambient_pressure", ambient_pressure.value, "Pa"));
  land.cavitation_pressure = number_of("cavitation_pressure", cavitation_pressure.value, "Pa");
  if (!(land.cavitation_pressure >= 0 && land.cavitation_pressure <= land.ambient_pressure)) {
    throw InputError("cavitation_pressure is below 0 or above ambient_pressure");
  }
  const pad::LandFilm film = pad::land_film(land);
  py::dict of;
  using Point = pad::LandFilmPoint;
  const auto put = [&](const char* name, double Point::*member) {
    std::vector<double> values;
    for (const Point& point : film.points) values.push_back(point.*member);
    of[name] = array_of(values);
  };
  put("separation", &Point::separation);
  put("lift", &Point::lift);
  put("lift_scatter", &Point::lift_scatter);
  put("friction_stress", &Point::friction_stress);
  put("friction_scatter", &Point::friction_scatter);
  put("mean_gap", &Point::mean_gap);
  put("lowest_gap", &Point::lowest_gap);
  put("flow", &Point::flow);
  put("cavitated_fraction", &Point::cavitated_fraction);
  return of;
}

}  // namespace

void bind_land_film(py::module_& part) {
  part.def("land_film", &land_film_of, py::arg("heights"), py::arg("step"), py::arg("separations"), py::arg("width"),
           py::arg("speed"), py::arg("viscosity"), py::arg("edges") = "mirrored", py::arg("patches") = 4,
           py::arg("ambient_pressure") = 101325.0, py::arg("cavitation_pressure") = 0.0,
           R"(Lift of a flat land that slides over a rough liner, at stated separations.

heights: levelled map of shape (y, x) [m], the motion along x. step: [m]. separations: distances of the mean planes,
above the highest point [m]. width: of the land along the motion [m]. speed [m/s], viscosity [Pa s]. edges: "mirrored"
or "periodic", across the motion. patches: of the map at most. Pressures are absolute [Pa].

Returns a dict of arrays: separation, lift, lift_scatter, friction_stress, friction_scatter, mean_gap, lowest_gap, flow,
cavitated_fraction. Raises InputError, ConvergenceError, TypeError. Source: docs/theory, eq-land-lift.)");
}

}  // namespace ringfilm::python
