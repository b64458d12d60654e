#include "ringfilm/models/gas/mixture.hpp"

#include <cmath>

#include "ringfilm/base/constants.hpp"

namespace ringfilm::models {
namespace {

/// What is known of a species.
struct SpeciesData {
  double molar_mass;               ///< [kg/mol]
  std::array<double, 5> heat;      ///< c_p M/R_m = a_0 + a_1 T + ... + a_4 T^4, T in K
  double viscosity;                ///< at `temperature` [Pa s]
  double temperature, sutherland;  ///< reference temperature and constant of Sutherland's law [K]
};

/// Heat capacities of smith1999, 300 to 1000 K; viscosities of white2006. Vapours of gasoline and diesel fuel and the
/// viscosity of methane: typical, assumed.
constexpr std::array<SpeciesData, kNSpecies> kSpecies{{
    {28.0134e-3, {3.298677, 1.4082404e-3, -3.963222e-6, 5.641515e-9, -2.444854e-12}, 1.663e-5, 273, 107},
    {31.9988e-3, {3.78245636, -2.99673416e-3, 9.84730201e-6, -9.68129509e-9, 3.24372837e-12}, 1.919e-5, 273, 139},
    {39.948e-3, {2.5, 0, 0, 0, 0}, 2.125e-5, 273, 144},
    {44.0095e-3, {2.35677352, 8.98459677e-3, -7.12356269e-6, 2.45919022e-9, -1.43699548e-13}, 1.370e-5, 273, 222},
    {18.01528e-3, {4.19864056, -2.0364341e-3, 6.52040211e-6, -5.48797062e-9, 1.77197817e-12}, 1.12e-5, 350, 1064},
    {2.01588e-3, {2.34433112, 7.98052075e-3, -1.9478151e-5, 2.01572094e-8, -7.37611761e-12}, 8.411e-6, 273, 97},
    {16.04246e-3, {5.14987613, -1.36709788e-2, 4.91800599e-5, -4.84743026e-8, 1.66693956e-11}, 1.026e-5, 273, 198},
    {110.0523e-3, {3.31, 6.75e-2, -1.853e-5, 0, 0}, 5.5e-6, 273, 330},
    {170.0474e-3, {5.11, 0.1043, -2.86e-5, 0, 0}, 4.5e-6, 273, 400},
}};

const SpeciesData& species_data(Species of) { return kSpecies[static_cast<std::size_t>(of)]; }

/// phi_ij of eq-wilke.
double wilke_factor(double mu_i, double mu_j, double M_i, double M_j) {
  const double root = 1 + std::sqrt(mu_i / mu_j) * std::pow(M_j / M_i, 0.25);
  return root * root / std::sqrt(8 * (1 + M_i / M_j));
}

double wilke_viscosity(const Shares& moles, double T) {
  std::array<double, kNSpecies> mu{};
  for (std::size_t i = 0; i < kNSpecies; ++i) mu[i] = viscosity(static_cast<Species>(i), T);
  double sum = 0;
  for (std::size_t i = 0; i < kNSpecies; ++i) {
    if (moles[i] == 0) continue;
    double around = 0;
    for (std::size_t j = 0; j < kNSpecies; ++j) {
      if (moles[j] == 0) continue;
      around +=
          i == j ? moles[j] : moles[j] * wilke_factor(mu[i], mu[j], kSpecies[i].molar_mass, kSpecies[j].molar_mass);
    }
    sum += moles[i] * mu[i] / around;
  }
  return sum;
}

}  // namespace

double molar_mass(Species of) { return species_data(of).molar_mass; }

double specific_heat(Species of, double T) {
  const auto& a = species_data(of).heat;
  return base::kMolarGasConstant / species_data(of).molar_mass *
         (a[0] + T * (a[1] + T * (a[2] + T * (a[3] + T * a[4]))));
}

double viscosity(Species of, double T) {
  const SpeciesData& known = species_data(of);
  return known.viscosity * std::pow(T / known.temperature, 1.5) * (known.temperature + known.sutherland) /
         (T + known.sutherland);
}

double molar_mass(const Shares& mass) {
  double moles = 0;
  for (std::size_t i = 0; i < kNSpecies; ++i) moles += mass[i] / kSpecies[i].molar_mass;
  return 1 / moles;
}

Shares mole_shares(const Shares& mass) {
  const double M = molar_mass(mass);
  Shares moles{};
  for (std::size_t i = 0; i < kNSpecies; ++i) moles[i] = mass[i] * M / kSpecies[i].molar_mass;
  return moles;
}

MixtureProperties mixture_properties(const Shares& mass, double T) {
  const double R = base::kMolarGasConstant / molar_mass(mass);
  double c_p = 0;
  for (std::size_t i = 0; i < kNSpecies; ++i) c_p += mass[i] * specific_heat(static_cast<Species>(i), T);
  return {R, c_p / (c_p - R), wilke_viscosity(mole_shares(mass), T)};
}

Shares mixed(const Shares& first, const Shares& other, double second) {
  Shares both{};
  for (std::size_t i = 0; i < kNSpecies; ++i) both[i] = (1 - second) * first[i] + second * other[i];
  return both;
}

}  // namespace ringfilm::models
