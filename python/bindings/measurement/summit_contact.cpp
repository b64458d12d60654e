#include "ringfilm/models/contact/summit_contact.hpp"

#include "measurement/height_maps.hpp"

namespace ringfilm::python {
namespace {

const std::map<std::string, models::ContactModel> kModels{
    {"greenwood-tripp", models::ContactModel::kGreenwoodTripp},
    {"greenwood-williamson", models::ContactModel::kGreenwoodWilliamson},
    {"bush-gibson-thomas", models::ContactModel::kBushGibsonThomas},
    {"plastic", models::ContactModel::kPlastic}};
const std::map<std::string, models::AsperityLaw> kAsperities{
    {"elastic", models::AsperityLaw::kElastic},
    {"zhao-maietta-chang", models::AsperityLaw::kZhaoMaiettaChang},
    {"kogut-etsion", models::AsperityLaw::kKogutEtsion},
    {"jackson-green", models::AsperityLaw::kJacksonGreen}};
const std::map<std::string, models::SummitPlane> kPlanes{{"surface", models::SummitPlane::kSurface},
                                                         {"nayak", models::SummitPlane::kNayak}};
const std::map<std::string, models::ContactMoments> kMoments{{"pair", models::ContactMoments::kPair},
                                                             {"one-surface", models::ContactMoments::kOneSurface}};

double positive(const char* name, const GivenNumber& given, const char* unit) {
  const double value = number_of(name, given.value, unit);
  if (!(value > 0)) throw InputError(std::string(name) + " is not above 0");
  return value;
}

py::dict summit_contact_of(const GivenNumbers& separations, const GivenNumber& N, const GivenNumber& beta,
                           const GivenNumber& sigma, const GivenNumber& E_prime, const GivenText& model,
                           const GivenText& asperity, const GivenText& summit_plane, const GivenText& moments,
                           const GivenMaybeNumber& hardness, const GivenNumber& poissons_ratio) {
  models::SummitContactChoice choice;
  choice.model = chosen("model", model, kModels);
  choice.asperity = chosen("asperity", asperity, kAsperities);
  choice.plane = chosen("summit_plane", summit_plane, kPlanes);
  choice.moments = chosen("moments", moments, kMoments);
  choice.nu = number_of("poissons_ratio", poissons_ratio.value, "1");
  const auto H = maybe_number_of("hardness", hardness.value, "Pa");
  const bool flows = choice.model == models::ContactModel::kPlastic || choice.asperity != models::AsperityLaw::kElastic;
  if (flows && !(H && *H > 0)) throw InputError("hardness is missing or not above 0", "this law flows at the hardness");
  choice.hardness = H.value_or(0);
  const models::GreenwoodTripp::Parameters pair{positive("asperity_density", N, "m-2"),
                                                positive("asperity_radius", beta, "m"),
                                                positive("roughness", sigma, "m"), positive("E_prime", E_prime, "Pa")};
  const auto law = models::summit_contact(pair, choice);
  std::vector<double> pressure, area;
  for (const double h : row_of("separations", separations.value)) {
    if (!(h >= 0)) throw InputError("a separation is below 0");
    const models::PressureAndArea at = law(h);
    pressure.push_back(at.pressure);
    area.push_back(at.area_share);
  }
  py::dict of;
  of["contact_pressure"] = array_of(pressure);
  of["real_area"] = array_of(area);
  return of;
}

}  // namespace

void bind_summit_contact(py::module_& part) {
  part.def("summit_contact", &summit_contact_of, py::arg("separations"), py::arg("asperity_density"),
           py::arg("asperity_radius"), py::arg("roughness"), py::arg("E_prime"),
           py::arg("model") = "greenwood-williamson", py::arg("asperity") = "elastic",
           py::arg("summit_plane") = "nayak", py::arg("moments") = "pair", py::arg("hardness") = py::none(),
           py::arg("poissons_ratio") = 0.3,
           R"(Closed laws of Gaussian surfaces by their summits, as contact.model and the keys next to it choose them.

separations: of the mean planes [m]. asperity_density [1/m2], asperity_radius [m], roughness [m]: of the pair.
E_prime: 2 E* [Pa]. model: "greenwood-tripp", "greenwood-williamson", "bush-gibson-thomas", "plastic". asperity:
"elastic", "zhao-maietta-chang", "kogut-etsion", "jackson-green". summit_plane: "surface", "nayak". moments: "pair",
"one-surface". hardness, poissons_ratio: of the softer face; all but elastic laws need the hardness [Pa].

Returns a dict of arrays: contact_pressure [Pa], real_area [-]. Raises InputError, TypeError.
Source: docs/theory, eq-summit-contact, eq-bush-gibson-thomas, eq-plastic-contact.)");
}

}  // namespace ringfilm::python
