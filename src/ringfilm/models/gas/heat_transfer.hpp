#pragma once

/// Transfer of heat and of vapour between the gas in the cylinder and the liner (docs/theory/oil-consumption.md).
namespace ringfilm::models {

/// Factors of the mean piston speed in Woschni's gas velocity @cite heywood1988, eq-woschni-velocity [-].
inline constexpr double kWoschniGasExchange = 6.18, kWoschniClosed = 2.28;
/// Factor of the rise of the pressure over the motored one, during combustion and expansion [m/(s K)].
inline constexpr double kWoschniCombustion = 3.24e-3;

/// Heat transfer coefficient after Woschni @cite heywood1988, eq-woschni [W/(m2 K)].
/// @param bore [m] @param pressure of the gas [Pa] @param temperature of the gas [K] @param velocity [m/s]
double woschni_coefficient(double bore, double pressure, double temperature, double velocity);

/// Mass transfer coefficient by the analogy of heat and mass transfer, eq-analogy [m/s].
/// @param alpha heat transfer coefficient [W/(m2 K)] @param density of the gas next to the wall [kg/m3]
/// @param heat_capacity of the gas at constant pressure [J/(kg K)] @param lewis_number [-]
double mass_transfer_coefficient(double alpha, double density, double heat_capacity, double lewis_number);

}  // namespace ringfilm::models
