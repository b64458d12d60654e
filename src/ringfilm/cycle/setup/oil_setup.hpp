#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/case/case.hpp"
#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/cycle/setup/setup.hpp"
#include "ringfilm/models/oil/lubricant.hpp"

namespace ringfilm::cycle {

/// Can an oil weigh as much, at any temperature and pressure [kg/m3]? Another number is of another unit.
inline bool is_oil_density(double density) { return density > 100 && density < 5000; }
/// Allowed range of the density of an oil, for messages.
inline constexpr const char* kAllowedOilDensity = "allowed is above 100 to below 5000 kg/m3";

/// "120.0 degC", for messages.
std::string celsius(double temperature);

struct PreparedOil {
  OilSetup setup;                                     ///< without fits until fit_properties
  std::shared_ptr<models::OilOverTemperature> range;  ///< oil over temperature that `setup` refers to
  std::vector<Note> notes;                            ///< extrapolations, in a reader's units
};

/// What decides on the temperature of a film without walls, and where in the stroke one with walls is looked at.
struct OilConditions {
  double temperature;  ///< operating.oil_temperature [K]
  double stroke;       ///< [m]
  double rise = 0;     ///< largest rise of the film above its walls for which the oil is needed [K]
};

/// The oil of a case at the temperatures of its film, by the laws that the case names.
PreparedOil prepared_oil(const Lubricant& lubricant, std::optional<models::WallTemperatures> walls,
                         const OilConditions& conditions);

/// An oil that the caller supplies, with a note on it. Throws InputError without a law, or where it has no value
/// up to the pressures that its fits are to reach (see fit_properties). @param temperature [K]
PreparedOil own_oil(const std::string& name, std::shared_ptr<const models::OilAtTemperature> law, double temperature,
                    double largest_mean_pressure);

/// Gives the oil its polynomials for the inner loop, from zero to four times the largest mean pressure on the face [Pa]
/// and 20 MPa at least; to half of that where no certified fit reaches further. Adds a note where there is none at all.
void fit_properties(PreparedOil& oil, double largest_mean_pressure);

/// Viscosity without shear at atmospheric pressure; nothing where the table of the oil does not reach the temperature
/// [Pa s].
std::optional<double> viscosity_without_shear(const Lubricant& lubricant, double temperature);

/// The same of the oil before fuel and water came into it [Pa s].
std::optional<double> fresh_viscosity_without_shear(const Lubricant& lubricant, double temperature);

/// The law of an oil that thins with the shear rate, without its critical shear rate; nothing for a Newtonian one.
std::optional<models::ShearThinning> shear_thinning(const Lubricant& lubricant);

/// The oil of a pad. Its laws count from the zero of the pad's pressures.
struct PadOil {
  std::shared_ptr<const models::OilAtTemperature> law;
  double viscosity = 0, density = 0;  ///< at that zero [Pa s], [kg/m3]
  /// Temperature of the film; nothing: the case states viscosity and density [K]
  std::optional<double> temperature;
  std::optional<film::ThinningOil> thinning;  ///< nothing: the oil is Newtonian
  std::vector<Note> notes;                    ///< extrapolations
};

/// With viscosity and density as stated, or with those at the temperature that the walls give the film.
PadOil pad_oil(const Case& c);

}  // namespace ringfilm::cycle
