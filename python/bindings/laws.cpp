#include <cmath>

#include "case_object.hpp"
#include "measurement/height_maps.hpp"
#include "record.hpp"
#include "ringfilm/base/display.hpp"
#include "ringfilm/cycle/pack/rails_of_pack.hpp"
#include "ringfilm/cycle/setup/setup.hpp"
#include "ringfilm/models/contact/asperity_contact.hpp"
#include "ringfilm/models/oil/lubricant.hpp"
#include "ringfilm/models/oil/oil_temperature.hpp"
#include "ringfilm/pad/pad_setup.hpp"

namespace ringfilm::python {
namespace {

using namespace models;

const std::map<std::string, ContactIntegralForm> kIntegralForms{
    {"exact", ContactIntegralForm::kExact},
    {"polynomial-4-digit", ContactIntegralForm::kPolynomial4Digit},
    {"polynomial-as-printed", ContactIntegralForm::kPolynomialAsPrinted}};

/// An oil at one temperature.
struct Oil {
  std::shared_ptr<const OilAtTemperature> oil;
  double temperature;       ///< [K]
  double ambient_pressure;  ///< pressure of the ambient air, as the laws of the oil count it [Pa]
};

Oil oil_of(const GivenOne<CaseObject>& given) {
  CaseObject& self = one_of("case", given);
  self.check();
  const cycle::Case& c = self.value();
  if (c.problem == cycle::Problem::kPad) return {pad::prepare_pad(c).oil, c.operating.oil_temperature, 0};
  // The oil of a pack is the same at each ring; its pressures here are those of the first.
  const cycle::OilSetup oil = cycle::prepare(c.is_pack() ? cycle::with_rails(c).rings.front() : c).ring.oil;
  return {oil.range->at(oil.temperature), oil.temperature, base::kAtmosphere};
}

GreenwoodTripp contact_of(const GivenNumber& N, const GivenNumber& beta, const GivenNumber& sigma,
                          const GivenNumber& E_prime, const GivenText& integrals) {
  const auto above_zero = [](const char* name, const GivenNumber& given, const char* unit) {
    const double value = number_of(name, given.value, unit);
    if (std::isfinite(value) && value > 0) return value;
    throw InputError(std::string(name) + " = " + number_text(value) + " is not a finite number above 0",
                     "state N in 1/m2, beta and sigma in m, E_prime in Pa");
  };
  return GreenwoodTripp({above_zero("N", N, "1/m2"), above_zero("beta", beta, "m"), above_zero("sigma", sigma, "m"),
                         above_zero("E_prime", E_prime, "Pa"), chosen("integrals", integrals, kIntegralForms)});
}

py::tuple state_of(const GreenwoodTripp& contact) {
  const auto& [N, beta, sigma, E_prime, form] = contact.parameters();
  return py::make_tuple(N, beta, sigma, E_prime, word_of(form, kIntegralForms));
}

void bind_contact(py::module_& part) {
  const auto parameter = [](double GreenwoodTripp::Parameters::*member) {
    return [member](const GreenwoodTripp& self) { return self.parameters().*member; };
  };
  py::class_<GreenwoodTripp>(part, "GreenwoodTripp",
                             R"(Contact of two rough surfaces after Greenwood and Tripp (1971).

N [1/m2], beta [m], sigma [m], E_prime [Pa] of 2/E_prime = sum (1 - nu^2)/E. Source: eq-asperity-load.)")
      .def(py::init(&contact_of), py::arg("N"), py::arg("beta"), py::arg("sigma"), py::arg("E_prime"),
           py::arg("integrals") = "exact",
           "integrals: \"exact\", \"polynomial-4-digit\", \"polynomial-as-printed\". Raises InputError, TypeError.")
      .def_property_readonly("N", parameter(&GreenwoodTripp::Parameters::N), "Density of asperity peaks [1/m2].")
      .def_property_readonly("beta", parameter(&GreenwoodTripp::Parameters::beta), "Mean radius of their summits [m].")
      .def_property_readonly("sigma", parameter(&GreenwoodTripp::Parameters::sigma), "Composite roughness [m].")
      .def_property_readonly("E_prime", parameter(&GreenwoodTripp::Parameters::E_prime), "Composite modulus [Pa].")
      .def_property_readonly(
          "integrals", [](const GreenwoodTripp& self) { return word_of(self.parameters().form, kIntegralForms); },
          "Where the height integrals come from, as stated.")
      .def(
          "pressure",
          [](const GreenwoodTripp& self, const GivenNumbers& h) {
            return mapped("h", h, [&self](double at) { return self.contact(at).pressure; });
          },
          py::arg("h"),
          "Pressure on the nominal area at the separation h, any shape [m -> Pa]. Below 0, which a solver may try on "
          "its way, it continues along its tangent. NaN gives NaN. Raises InputError for masked values.")
      .def(
          "pressure_slope",
          [](const GreenwoodTripp& self, const GivenNumbers& h) {
            return mapped("h", h, [&self](double at) { return self.contact(at).pressure_slope; });
          },
          py::arg("h"), "Its slope over h, any shape [m -> Pa/m]; as pressure().")
      .def(
          "area_share",
          [](const GreenwoodTripp& self, const GivenNumbers& h) {
            return mapped("h", h, [&self](double at) { return self.contact(at).area_share; });
          },
          py::arg("h"),
          "Real contact area per nominal area, any shape [m -> -]; as pressure(). Source: eq-asperity-area.")
      .def(
          "__eq__",
          [](const GreenwoodTripp& self, const py::object& other) -> py::object {
            if (!py::isinstance<GreenwoodTripp>(other)) return py::reinterpret_borrow<py::object>(Py_NotImplemented);
            return py::bool_(state_of(self).equal(state_of(py::cast<const GreenwoodTripp&>(other))));
          },
          py::arg("other"), "Are all parameters the same?")
      .def(py::pickle(&state_of,
                      [](const py::tuple& state) {
                        if (state.size() != 5) throw py::value_error("this is not a pickle of a GreenwoodTripp");
                        return contact_of({state[0]}, {state[1]}, {state[2]}, {state[3]}, {state[4]});
                      }))
      .def(
          "__repr__",
          [](const GreenwoodTripp& self) {
            const auto repr = [](const py::handle& value) { return py::cast<std::string>(py::repr(value)); };
            const py::tuple all = state_of(self);
            return "GreenwoodTripp(N=" + repr(all[0]) + ", beta=" + repr(all[1]) + ", sigma=" + repr(all[2]) +
                   ", E_prime=" + repr(all[3]) + ", integrals=" + repr(all[4]) + ")";
          },
          "As it would be made again.");
  part.def(
      "gaussian_integral",
      [](const GivenNumber& order, const GivenNumbers& lambda) {
        const double n = number_of("n", order.value, "");
        if (!(std::isfinite(n) && n >= 1)) throw InputError("n must be 1 or more", "contact requires 3/2, 2 and 5/2");
        return mapped("lambda_ratio", lambda, [n](double at) {
          if (!(at >= 0 && at <= 30)) throw InputError("lambda must lie between 0 and 30");
          return gaussian_integral(n, at);
        });
      },
      py::arg("n"), py::arg("lambda_ratio"),
      "F_n of the lambda ratio lambda, any shape, 0 to 30 [-]. Raises InputError. Source: eq-gaussian-integral.");
  part.def(
      "composite_modulus",
      [](const GivenNumbers& E_1, const GivenNumbers& nu_1, const GivenNumbers& E_2, const GivenNumbers& nu_2) {
        return mapped({{"E_1", &E_1}, {"nu_1", &nu_1}, {"E_2", &E_2}, {"nu_2", &nu_2}},
                      [](const std::vector<double>& of) { return composite_modulus(of[0], of[1], of[2], of[3]); });
      },
      py::arg("E_1"), py::arg("nu_1"), py::arg("E_2"), py::arg("nu_2"),
      R"(E' of 2/E' = sum (1 - nu^2)/E [Pa].

E_1, E_2: Young's moduli above 0 [Pa], inf for a rigid body. nu_1, nu_2: Poisson's ratios above -1 up to 0.5 [-].
Numbers or arrays of shapes that fit together. Raises InputError. Source: eq-composite-modulus.)");
}

void bind_oil(py::module_& part) {
  py::class_<Oil>(part, "Oil", "Density and viscosity of an oil at one temperature, against absolute pressure.")
      .def(
          "density",
          [](const Oil& self, const GivenNumbers& p) {
            return mapped("pressure", p, [&self](double at) { return self.oil->density(at); });
          },
          py::arg("pressure"), "Density, any shape [Pa -> kg/m3]. Raises InputError for masked values.")
      .def(
          "viscosity",
          [](const Oil& self, const GivenNumbers& p) {
            return mapped("pressure", p, [&self](double at) { return self.oil->viscosity(at); });
          },
          py::arg("pressure"), "Dynamic viscosity, any shape [Pa -> Pa s]. Raises InputError for masked values.")
      .def_readonly("temperature", &Oil::temperature, "Temperature of the oil [K].")
      .def(
          "__repr__",
          [](const Oil& self) {
            return "<ringfilm.laws.Oil at " + text_in(self.temperature, kCelsius) + ": " +
                   number_text(self.oil->density(self.ambient_pressure)) + " kg/m3, " +
                   text_in(self.oil->viscosity(self.ambient_pressure), kMillipascalSecond) + " at ambient pressure>";
          },
          "Temperature, and what it is at ambient pressure.");
  part.def("oil", &oil_of, py::arg("case"),
           "The oil of a case at its oil temperature, an Oil; of a pad its pressures count from their own zero. "
           "Raises InputError. Source: docs/theory/oil.md.");
  Record<Walther>(part, "Walther", "Kinematic viscosity against temperature after ASTM D341. Source: eq-walther.")
      .with("A", &Walther::A, "Of log10 log10(nu + 0.7) = A - B log10 T, nu in mm2/s, T in K [-].")
      .with("B", &Walther::B, "Its fall with temperature, above 0 [-].")
      .type()
      .def_static(
          "fit",
          [](const GivenNumbers& temperature, const GivenNumbers& viscosity) {
            return Walther::fit(row_of("temperature", temperature.value),
                                row_of("kinematic_viscosity", viscosity.value));
          },
          py::arg("temperature"), py::arg("kinematic_viscosity"),
          R"(Through two points, by least squares through more.

temperature, kinematic_viscosity: shape (points,) [K] and [m2/s]. Raises InputError for lists of different lengths,
temperatures at which no oil flows, masked values, and viscosities that do not fall. Source: eq-walther.)")
      .def(
          "kinematic_viscosity",
          [](const Walther& self, const GivenNumbers& temperature) {
            return mapped("temperature", temperature, [&self](double at) {
              check_oil_temperature(at);
              return self.kinematic_viscosity(at);
            });
          },
          py::arg("temperature"),
          "Any shape [K -> m2/s]. Raises InputError for temperatures at which no oil flows, as degrees Celsius are.");
}

}  // namespace

void bind_laws(py::module_& module) {
  py::module_ part = module.def_submodule("laws", "Laws of contact and oil; see ringfilm.laws.");
  bind_contact(part);
  bind_summit_contact(part);
  bind_oil(part);
}

}  // namespace ringfilm::python
