#pragma once
#include <cstdio>
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "ringfilm/cycle/simulate.hpp"

/// The paper's rings as Case values, built without the case reader.
namespace ringfilm::cycle::testing {

using Columns = std::map<std::string, std::vector<double>>;

inline Columns read_columns(const std::string& path) {
  std::ifstream file(RINGFILM_SOURCE_FOLDER "/" + path);
  std::string line;
  std::getline(file, line);
  std::vector<std::string> names;
  std::stringstream header(line);
  for (std::string name; std::getline(header, name, ',');) names.push_back(name);
  Columns columns;
  while (std::getline(file, line)) {
    std::stringstream row(line);
    std::string cell;
    for (const auto& name : names) {
      std::getline(row, cell, ',');
      columns[name].push_back(std::stod(cell));
    }
  }
  return columns;
}

inline Case styles_new_ring() {
  Case c;
  c.title = "new ring";
  c.engine = {0.089, 0.0795, 0.1381, {}};
  c.operating = {1500 * 2 * std::numbers::pi / 60, 393.15, {}, {}};
  Columns trace = read_columns("cases/styles2014/cylinder_pressure_1500rpm_synthetic.csv");
  c.gas.cylinder_pressure =
      SampledTrace{trace.begin()->second, trace.rbegin()->second};  // "crank_angle ...", "cylinder_pressure ..."
  c.ring.face_width = 1.2e-3;
  c.ring.elastic_pressure = 2e5;
  c.ring.face.form = FaceForm::kPolynomial;
  c.ring.face.coefficients = {427.9, -1455.8, 1971.4, -1354.4, 544.57, -150.49, 25.30};
  c.ring.face.length_unit = 1e-3;
  c.ring.face.height_unit = 1e-6;
  c.contact.asperity_density = 0.097e12;
  c.contact.asperity_radius = 1.56e-6;
  c.contact.roughness = 0.48e-6;
  c.contact.boundary_shear_strength_coefficient = 0.3581;
  c.lubricant.kinematic_viscosity = {{313.15, 59.99e-6}, {373.15, 9.590e-6}};
  c.lubricant.density = {{288.15, 849.7}, {313.15, 833.8}};
  c.film.cavitation = Cavitation::kReynoldsExit;
  c.solver.crank_step_control = StepControl::kFixed;
  return c;
}

/// With steps of first order, as in the independent model.
inline Case by_backward_euler(Case c) {
  c.solver.time_scheme = TimeScheme::kBackwardEuler;
  return c;
}

inline Case styles_embedded_ring() {
  Case c = styles_new_ring();
  c.title = "embedded ring";
  c.ring.face.coefficients = {-6.493, -49.845, 143.22, -98.541, 27.351, -17.338, 7.4986};
  c.contact.asperity_density = 0.101e12;
  c.contact.asperity_radius = 1.82e-6;
  c.contact.roughness = 0.35e-6;
  c.contact.boundary_shear_strength_coefficient = 0.1423;
  return c;
}

inline Case styles_run_in_ring() {
  Case c = styles_new_ring();
  c.title = "run-in ring";
  c.ring.face.coefficients = {-197.16, 578.85, -583.44, 200.37, 56.366, -62.709, 13.857};
  c.contact.asperity_density = 0.100e12;
  c.contact.asperity_radius = 1.34e-6;
  c.contact.roughness = 0.50e-6;
  c.contact.boundary_shear_strength_coefficient = 0.2565;
  return c;
}

inline CycleResult simulated(const Case& c) { return simulate(prepare(c)); }

}  // namespace ringfilm::cycle::testing
