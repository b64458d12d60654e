#include "case_object.hpp"
#include "height_maps.hpp"
#include "record.hpp"
#include "ringfilm/cycle/setup.hpp"
#include "ringfilm/models/asperity_contact.hpp"
#include "ringfilm/models/lubricant.hpp"
#include "ringfilm/pad/pad_setup.hpp"

namespace ringfilm::python {
namespace {

using namespace models;

/// An oil at one temperature.
struct Oil {
  std::shared_ptr<const OilAtTemperature> oil;
};

Oil oil_of(CaseObject& self) {
  self.check();
  if (self.value().problem == cycle::Problem::kPad) return {pad::prepare_pad(self.value()).oil};
  return {cycle::prepare(self.value()).oil};
}

void bind_contact(py::module_& part) {
  py::class_<GreenwoodTripp>(part, "GreenwoodTripp",
                             R"(Contact of two rough surfaces after Greenwood and Tripp (1971).

N [1/m2], beta [m], sigma [m], E_prime [Pa] of 2/E_prime = sum (1 - nu^2)/E. Source: eq-asperity-load.)")
      .def(py::init([](double N, double beta, double sigma, double E_prime, const std::string& integrals) {
             const std::map<std::string, ContactIntegralForm> forms{
                 {"exact", ContactIntegralForm::kExact},
                 {"polynomial-4-digit", ContactIntegralForm::kPolynomial4Digit},
                 {"polynomial-as-printed", ContactIntegralForm::kPolynomialAsPrinted}};
             for (const double value : {N, beta, sigma, E_prime}) {
               if (!(value > 0)) throw InputError("N, beta, sigma and E_prime must be above 0", "state them in SI");
             }
             return GreenwoodTripp({N, beta, sigma, E_prime, chosen("integrals", integrals, forms)});
           }),
           py::arg("N"), py::arg("beta"), py::arg("sigma"), py::arg("E_prime"), py::arg("integrals") = "exact",
           "integrals: \"exact\", \"polynomial-4-digit\", \"polynomial-as-printed\". Raises InputError.")
      .def(
          "pressure",
          [](const GreenwoodTripp& self, const Heights& h) {
            return py::vectorize([&self](double at) { return self.contact(at).pressure; })(h);
          },
          py::arg("h"), "Pressure on the nominal area at the separation h, any shape [m -> Pa].")
      .def(
          "pressure_slope",
          [](const GreenwoodTripp& self, const Heights& h) {
            return py::vectorize([&self](double at) { return self.contact(at).pressure_slope; })(h);
          },
          py::arg("h"), "Its slope over h, any shape [m -> Pa/m].")
      .def(
          "area_share",
          [](const GreenwoodTripp& self, const Heights& h) {
            return py::vectorize([&self](double at) { return self.contact(at).area_share; })(h);
          },
          py::arg("h"), "Real contact area per nominal area, any shape [m -> -]. Source: eq-asperity-area.");
  part.def(
      "gaussian_integral",
      [](double n, const Heights& lambda) {
        if (!(n >= 1)) throw InputError("n must be 1 or more", "contact wants 3/2, 2 and 5/2");
        return py::vectorize([n](double at) {
          if (!(at >= 0 && at <= 30)) throw InputError("lambda must lie between 0 and 30");
          return gaussian_integral(n, at);
        })(lambda);
      },
      py::arg("n"), py::arg("film_parameter"),
      "F_n of the film parameter lambda, any shape, 0 to 30 [-]. Raises InputError. Source: eq-gaussian-integral.");
  part.def("composite_modulus", py::vectorize(&composite_modulus), py::arg("E_1"), py::arg("nu_1"), py::arg("E_2"),
           py::arg("nu_2"), "E' of 2/E' = sum (1 - nu^2)/E; numbers or arrays [Pa]. Source: eq-composite-modulus.");
}

void bind_oil(py::module_& part) {
  py::class_<Oil>(part, "Oil", "Density and viscosity of an oil at one temperature, against absolute pressure.")
      .def(
          "density",
          [](const Oil& self, const Heights& p) {
            return py::vectorize([&self](double at) { return self.oil->density(at); })(p);
          },
          py::arg("pressure"), "Density, any shape [Pa -> kg/m3].")
      .def(
          "viscosity",
          [](const Oil& self, const Heights& p) {
            return py::vectorize([&self](double at) { return self.oil->viscosity(at); })(p);
          },
          py::arg("pressure"), "Dynamic viscosity, any shape [Pa -> Pa s].");
  part.def("oil", &oil_of, py::arg("case"),
           "The oil of a case at its oil temperature, an Oil; of a pad its pressures count from their own zero. "
           "Raises InputError. Source: docs/theory/oil.md.");
  py::class_<Walther>(part, "Walther", "Kinematic viscosity against temperature after ASTM D341. Source: eq-walther.")
      .def_static(
          "fit",
          [](const Heights& temperature, const Heights& viscosity) {
            return Walther::fit(numbers_of(temperature), numbers_of(viscosity));
          },
          py::arg("temperature"), py::arg("kinematic_viscosity"),
          "Through two points or more: shape (points,) [K] and [m2/s]. Raises InputError.")
      .def(
          "kinematic_viscosity",
          [](const Walther& self, const Heights& temperature) {
            return py::vectorize([&self](double at) { return self.kinematic_viscosity(at); })(temperature);
          },
          py::arg("temperature"), "Any shape [K -> m2/s].");
}

}  // namespace

void bind_laws(py::module_& module) {
  py::module_ part = module.def_submodule("laws", "Laws of contact and oil; see ringfilm.laws.");
  bind_contact(part);
  bind_oil(part);
}

}  // namespace ringfilm::python
