#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/case/case.hpp"
#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/film/factors/factor_laws.hpp"
#include "ringfilm/film/kernels/kernels.hpp"
#include "ringfilm/models/contact/asperity_contact.hpp"
#include "ringfilm/models/crank_slider.hpp"
#include "ringfilm/models/gas/gas.hpp"
#include "ringfilm/models/oil/oil_over_temperature.hpp"
#include "ringfilm/models/radial_collapse.hpp"
#include "ringfilm/models/ring.hpp"
#include "ringfilm/models/section/twisting_ring.hpp"
#include "ringfilm/models/wall_temperature.hpp"

namespace ringfilm::cycle {

/// Cells across the face.
enum class CellsOfFace {
  kUniform,  ///< `solver.cells`, all alike
  kGraded    ///< `solver.cells`, and many more near the lowest places of the face: film::graded_grid
};

/// Do the strips of a ring that bends, and the liner, flatten under what they carry?
enum class Surfaces {
  kRigid,      ///< no
  kFlattening  ///< by eq-ring-flattening; asperities take over where the film closes
};

/// What all rings of an engine have in common.
struct EngineSetup {
  models::CrankSlider crank;  ///< moves piston and rings
  double speed;               ///< speed of the crankshaft [rad/s]
};

/// Gas pressures at the edges of a ring's face, absolute, 0 = firing TDC.
struct LandPressures {
  models::CyclePressure above;  ///< gas pressure above the ring; for the top ring that of the cylinder [Pa]
  models::CyclePressure below;  ///< gas pressure below the ring; for the last ring that of the crankcase [Pa]
  std::optional<models::CyclePressure> behind = std::nullopt;  ///< in the groove, where the gas path is computed [Pa]
};

/// The oil of a ring's film, at the temperatures that it has along the stroke.
struct OilSetup {
  std::optional<models::WallTemperatures> walls;            ///< nothing: one temperature, `temperature`
  std::shared_ptr<const models::OilOverTemperature> range;  ///< with fits where solver.properties asks for them
  double temperature;                         ///< temperature of the film; with walls, in the middle of the stroke [K]
  double viscosity;                           ///< at `temperature` and no pressure [Pa s]
  double density;                             ///< density at `temperature` and no pressure [kg/m3]
  double hottest = 0;                         ///< up to which `range` serves a film that its own shear heats [K]
  std::optional<film::ThinningOil> thinning;  ///< nothing: the oil is Newtonian
  /// Viscosity of an oil that thins, at 150 degC and high shear rate, where it is known [Pa s]
  std::optional<double> hths_viscosity;
};

/// One ring and what it meets.
struct RingSetup {
  models::RingFace face;    ///< as given, before turning and before its minimum is subtracted
  double elastic_pressure;  ///< p_e [Pa]
  double E_prime;           ///< E' of 2/E' = sum (1 - nu^2)/E [Pa]
  double sigma;             ///< composite roughness as the contact model uses it [m]
  std::shared_ptr<const models::AsperityContact> contact;  ///< law of the pair
  /// Asperities of the pair; nothing: the law is a table
  std::optional<models::GreenwoodTripp::Parameters> asperities;
  LandPressures lands;                                ///< gas above and below
  OilSetup oil;                                       ///< oil of the ring's film
  film::FactorLaws factors;                           ///< flow factors of the ring's film
  std::optional<models::TwistingRing> twisting = {};  ///< section that turns over the cycle; nothing: it does not
  double mass = 0;                       ///< mass of a ring that twists; 0: not known, without inertia [kg]
  models::RadialCollapse collapse = {};  ///< what the ring does that gas presses off the liner
  std::shared_ptr<const models::LandLift> land = nullptr;  ///< lift of the honing; nullptr: none
};

/// A case of one ring, set up for time integration: models built, traces joined. Immutable; may be used from several
/// threads.
struct Setup {
  Case input;               ///< the case as given
  EngineSetup engine;       ///< crank and speed
  RingSetup ring;           ///< the ring with its contact, gas and oil
  std::vector<Note> notes;  ///< what was found out on the way (extrapolated density, ...)

  const film::FilmKernels* kernels = &film::kernels();  ///< the inner loops that are to find the films
  CellsOfFace cells = CellsOfFace::kUniform;            ///< graded where uniform ones found no film
  Surfaces surfaces = Surfaces::kRigid;                 ///< flattening where rigid ones found no film
};

/// The elastic pressure of rings and what to check of another one, for messages.
std::string usual_tension();

/// p_e of the one way in which the case states the tension of the ring, eq-elastic-pressure [Pa].
double elastic_pressure(const Case& c);

/// What a ring does that gas presses off the bore. Where the case leaves thickness or gap open, those of a typical one.
models::RadialCollapse radial_collapse(const Case& c);

/// Crank of the case.
models::CrankSlider crank_slider(const Case& c);

/// Cylinder pressure of the case, of its trace or its Wiebe cycle. Throws InputError where prepare() does.
models::CyclePressure cylinder_pressure(const Case& c);

/// Pressure in the crankcase of the case, constant or a trace.
models::CyclePressure crankcase_pressure(const Case& c);

/// Temperatures of the walls; nothing where the case has one temperature of the oil, or none.
std::optional<models::WallTemperatures> wall_temperatures(const Thermal& thermal);

/// By what the film of a case differs from that of a Newtonian oil between smooth walls. @param sigma [m]
film::FactorLaws factor_laws(const Case& c, double sigma, const std::optional<film::ThinningOil>& thinning);

/// Builds the models of a checked case. Throws InputError for a pack or a ring with several rails, which has several
/// faces, and where a value that is fine by itself cannot be used with the others (partial trace without intake
/// pressure, peak that the Wiebe cycle cannot reach).
Setup prepare(const Case& c);

/// An oil that the caller brings in place of the laws of a case.
struct OwnOil {
  std::string name;                                     ///< for the notes of the result, e.g. "Carreau, batch 7"
  std::shared_ptr<const models::OilAtTemperature> law;  ///< at operating.oil_temperature; see oil_of_functions
};

/// Sets up a case with an oil of the caller's own. lubricant.* of the case is ignored, and a note in the result reports
/// that. Throws InputError also where the law has no value (check_oil), and for a case with [thermal].
Setup prepare(const Case& c, const OwnOil& oil);

}  // namespace ringfilm::cycle
