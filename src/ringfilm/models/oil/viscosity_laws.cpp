#include "ringfilm/models/oil/viscosity_laws.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

#include "ringfilm/models/oil/roelands.hpp"

namespace ringfilm::models {
namespace {

struct ViscosityAndSlope {
  double eta;      // [Pa s]
  double deta_dp;  // [Pa s/Pa]
};

/// The curve of a law that is written for one pressure, `ViscosityAndSlope at(double p) const`.
template <class Law>
class CurveOf final : public ViscosityCurve {
 public:
  explicit CurveOf(const Law& law) : law_(law) {}

  void viscosity(std::span<const double> p, std::span<double> eta, std::span<double> deta_dp) const override {
    for (std::size_t i = 0; i < p.size(); ++i) {
      const ViscosityAndSlope found = law_.at(p[i]);
      eta[i] = found.eta;
      deta_dp[i] = found.deta_dp;
    }
  }

 private:
  Law law_;
};

template <class Law>
std::unique_ptr<const ViscosityCurve> curve_of(const Law& law) {
  return std::make_unique<CurveOf<Law>>(law);
}

// --- the laws: each its curve and its entry in the table ----------------------------------------------------------

/// A viscosity that no pressure changes.
struct Isoviscous {
  double eta_T;

  ViscosityAndSlope at(double) const { return {eta_T, 0}; }
};

ViscosityLaw isoviscous() {
  return {.name = "none",
          .meaning = "constant",
          .equation = "eq-isoviscous",
          .parameters = {},
          .curve = [](const LawInputs& oil) { return curve_of(Isoviscous{oil.eta_T}); }};
}

LawParameter pressure_viscosity_coefficient() {
  return {.key = "pressure_viscosity_coefficient",
          .unit = "Pa-1",
          .display_unit = "Pa-1",
          .low = 0,
          .high = 1e-6,
          .usual = 1e-8,
          .statement = Statement::kDefault,
          .meaning = "pressure-viscosity coefficient, alpha_0; a pad must state it",
          .example = "\"1e-8 m2/N\""};
}

ViscosityLaw roelands() {
  return {.name = "roelands",
          .meaning = "Roelands' law in Houpert's form",
          .equation = "eq-roelands",
          .parameters = {pressure_viscosity_coefficient()},
          .curve = [](const LawInputs& oil) {
            const double Z = roelands_index(oil["pressure_viscosity_coefficient"], oil.eta_0);
            return Z == 0 ? curve_of(Isoviscous{oil.eta_T}) : roelands_curve(oil.eta_T, Z);
          }};
}

struct Barus {
  double eta_T, alpha;

  ViscosityAndSlope at(double p) const {
    const double eta = eta_T * std::exp(alpha * p);
    return {eta, alpha * eta};
  }
};

ViscosityLaw barus() {
  return {.name = "barus",
          .meaning = "Barus' exponential",
          .equation = "eq-barus",
          .parameters = {pressure_viscosity_coefficient()},
          .curve = [](const LawInputs& oil) {
            return curve_of(Barus{oil.eta_T, oil["pressure_viscosity_coefficient"]});
          }};
}

/// A further law goes to the end: the program finds the first ones by their place.
std::vector<ViscosityLaw> all_laws() { return {roelands(), isoviscous(), barus()}; }

}  // namespace

double LawInputs::operator[](std::string_view key) const {
  const auto found = parameters.find(key);
  if (found == parameters.end()) throw std::out_of_range("no law lists the parameter " + std::string(key));
  return found->second;
}

const std::vector<ViscosityLaw>& viscosity_laws() {
  static const std::vector<ViscosityLaw> laws = all_laws();
  return laws;
}

const ViscosityLaw& viscosity_law(ViscosityPressureLaw law) { return viscosity_laws().at(static_cast<int>(law)); }

bool takes(const ViscosityLaw& law, std::string_view key) {
  return std::any_of(law.parameters.begin(), law.parameters.end(),
                     [&](const LawParameter& parameter) { return parameter.key == key; });
}

std::vector<LawParameter> law_parameters() {
  std::vector<LawParameter> parameters;
  for (const ViscosityLaw& law : viscosity_laws()) {
    for (const LawParameter& parameter : law.parameters) {
      const bool known = std::any_of(parameters.begin(), parameters.end(),
                                     [&](const LawParameter& other) { return other.key == parameter.key; });
      if (!known) parameters.push_back(parameter);
    }
  }
  return parameters;
}

LawParameters usual_law_parameters() {
  LawParameters values;
  for (const LawParameter& parameter : law_parameters()) values[parameter.key] = parameter.usual;
  return values;
}

}  // namespace ringfilm::models
