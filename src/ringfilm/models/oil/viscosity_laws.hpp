#pragma once
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// The one table of the laws of viscosity against pressure. The choices of `lubricant.viscosity_pressure`, the case
/// keys of the laws' parameters, the list of keys in the manual and the tests of the laws all walk it; nothing else
/// depends on a single law. How to add one: docs/manual/extending/adding-a-law.md.
namespace ringfilm::models {

enum class Statement { kDefault, kRequired };

/// A number that one law or more take from the case.
struct LawParameter {
  std::string key;           ///< in a case file, below `lubricant.`
  std::string unit;          ///< SI unit in UDUNITS spelling; "1" dimensionless
  std::string display_unit;  ///< the unit in which people write and read it
  double low, high;          ///< range, both ends included [SI]
  double usual;              ///< usual value of an engine oil [SI]: the default, and the value in the tests of the laws
  Statement statement;       ///< may a case omit it?
  std::string meaning;       ///< one line: what it is, symbol
  std::string example;       ///< the right-hand side as one would write it in TOML
};

/// Values of parameters [SI] by their keys.
using LawParameters = std::map<std::string, double, std::less<>>;

/// Viscosity against pressure at one temperature. Immutable; may be used from several threads.
class ViscosityCurve {
 public:
  virtual ~ViscosityCurve() = default;

  /// Viscosity eta [Pa s] and its slope deta_dp [Pa s/Pa] at pressures p [Pa]; all spans of one length. The value at a
  /// pressure is the same in every company of others.
  virtual void viscosity(std::span<const double> p, std::span<double> eta, std::span<double> deta_dp) const = 0;
};

/// Properties of the oil that a law uses.
struct LawInputs {
  double eta_T;                     ///< viscosity at the temperature of the film and p = 0 [Pa s]
  double eta_0;                     ///< viscosity to which the stated coefficients belong [Pa s]
  const LawParameters& parameters;  ///< parameters of all laws [SI]

  /// The parameter of that key [SI]. Throws std::out_of_range where no law lists it.
  double operator[](std::string_view key) const;
};

/// One law.
struct ViscosityLaw {
  std::string name;      ///< as `lubricant.viscosity_pressure` has it
  std::string meaning;   ///< a few words
  std::string equation;  ///< its label in docs/theory/oil.md
  std::vector<LawParameter> parameters;
  /// The law of an oil at one temperature. Throws InputError where the law has no value for it.
  std::unique_ptr<const ViscosityCurve> (*curve)(const LawInputs& oil);
};

/// A law by its place in the table; named are those that the program itself asks for.
enum class ViscosityPressureLaw : int { kRoelands, kNone, kBarus };

/// All laws, in the order in which the case key names them.
const std::vector<ViscosityLaw>& viscosity_laws();

const ViscosityLaw& viscosity_law(ViscosityPressureLaw law);

/// Does the law take the parameter of that key?
bool takes(const ViscosityLaw& law, std::string_view key);

/// The parameters of all laws, each once, in the order of the table.
std::vector<LawParameter> law_parameters();

/// Their usual values [SI].
LawParameters usual_law_parameters();

}  // namespace ringfilm::models
