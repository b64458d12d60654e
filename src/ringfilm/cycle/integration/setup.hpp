#pragma once
#include <memory>
#include <string>
#include <vector>

#include "ringfilm/cycle/case/case.hpp"
#include "ringfilm/cycle/result.hpp"
#include "ringfilm/film/kernels/kernels.hpp"
#include "ringfilm/models/asperity_contact.hpp"
#include "ringfilm/models/crank_slider.hpp"
#include "ringfilm/models/gas/gas.hpp"
#include "ringfilm/models/oil/lubricant.hpp"
#include "ringfilm/models/ring.hpp"

namespace ringfilm::cycle {

/// Cells across the face.
enum class CellsOfFace {
  kUniform,  ///< `solver.cells`, all alike
  kGraded    ///< the same, and many more near the lowest places of the face: film::graded_grid
};

/// A case made ready to integrate: models built, trace joined, grid laid. Immutable; may be used from several threads.
struct Setup {
  Case input;                                ///< the case that was prepared, as given
  models::CrankSlider crank;                 ///< moves piston and ring
  models::CyclePressure cylinder_pressure;   ///< absolute [Pa], 0 = firing TDC
  models::CyclePressure crankcase_pressure;  ///< absolute [Pa]
  models::RingFace face;                     ///< as given, before turning and before its minimum is taken off
  double elastic_pressure;                   ///< p_e [Pa]
  double E_prime;                            ///< E' of 2/E' = sum (1 - nu^2)/E [Pa]
  double sigma;                              ///< composite roughness as the contact model uses it [m]
  models::GreenwoodTripp contact;            ///< asperity contact of the pair
  std::shared_ptr<const models::OilAtTemperature> oil;  ///< with fit() where solver.properties asks for it
  double oil_viscosity;                                 ///< at the oil temperature, no pressure [Pa s]
  double oil_density;                                   ///< likewise [kg/m3]
  std::vector<Note> notes;                              ///< what was found out on the way (extrapolated density, ...)

  const film::FilmKernels* kernels = &film::kernels();  ///< the inner loops that are to find the films
  CellsOfFace cells = CellsOfFace::kUniform;            ///< graded where uniform ones found no film
};

/// The elastic pressure of rings and what to check of another one, for messages.
std::string usual_tension();

/// p_e of the one way in which the case states the tension of the ring, eq-elastic-pressure [Pa].
double elastic_pressure(const Case& c);

/// Builds the models of a checked case. Throws InputError where a value that is fine by itself cannot be used with the
/// others (partial trace without intake pressure, peak that the Wiebe cycle cannot reach).
Setup prepare(const Case& c);

/// An oil that the caller brings in place of the laws of a case.
struct OwnOil {
  std::string name;                                     ///< for the notes of the result, e.g. "Carreau, batch 7"
  std::shared_ptr<const models::OilAtTemperature> law;  ///< at operating.oil_temperature; see oil_of_functions
};

/// The same with an oil of the caller's own; lubricant.* of the case is not looked at, and a note in the result says
/// so. Throws InputError also where the law has no value (check_oil).
Setup prepare(const Case& c, const OwnOil& oil);

}  // namespace ringfilm::cycle
