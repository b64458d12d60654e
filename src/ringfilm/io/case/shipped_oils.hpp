#pragma once
#include <string>
#include <vector>

#include "ringfilm/io/text/source_text.hpp"
#include "ringfilm/io/text/units.hpp"

/// The oils in data/lubricants of the shipped folder.
namespace ringfilm::io {

/// A shipped oil with its viscosities.
struct ShippedOil {
  std::string name;                    ///< as its file states it
  std::string grade;                   ///< "SAE 10W-40"; empty for an oil of no grade
  std::string file;                    ///< as a case anywhere names it: "data/lubricants/sae-10w-40.toml"
  double kinematic_viscosity_40 = 0;   ///< at 40 degC [m2/s]
  double kinematic_viscosity_100 = 0;  ///< at 100 degC [m2/s]
  double kinematic_viscosity_150 = 0;  ///< at 150 degC, by the oil's law of temperature [m2/s]
  double viscosity_150 = 0;            ///< dynamic, likewise, without shear thinning [Pa s]
};

/// All of them, by file name. Throws InputError where the shipped folder is not found, or a file is not an oil.
std::vector<ShippedOil> shipped_oils(const Units& units);

/// The file of the oil of that grade; "SAE 10W-40", "10w-40" and "10W40" are one. Throws InputError that lists the
/// grades.
NamedFile shipped_oil_of_grade(const std::string& grade);

/// The list for a terminal (`ringfilm oils`).
std::string oils_table(const std::vector<ShippedOil>& oils);

/// The list of oils as JSON, SI units.
std::string oils_json(const std::vector<ShippedOil>& oils);

}  // namespace ringfilm::io
