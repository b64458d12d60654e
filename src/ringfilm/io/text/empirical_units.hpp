#pragma once
#include <optional>
#include <string>

/// Units of the trade that a table or a formula converts, not a factor: HRC, SUS, degrees Engler.
namespace ringfilm::io {

/// The value in `si_unit` of a number in one of these units; nothing where `unit` is another one or measures something
/// else. Throws UnitError for a number outside the range of the conversion.
///
/// HRC [Pa]: Vickers hardness of steels that are not austenitic after @cite astm_e140, 20 to 68 HRC, straight between
/// every fifth value. SUS (SSU) [m2/s]: Saybolt universal seconds at 100 degF after @cite astm_d2161, from 32 s on; at
/// 210 degF 0.7 % more than the true viscosity. degE [m2/s]: degrees Engler by the formula of Ubbelohde, from 1.2 on.
std::optional<double> empirical_quantity(double value, const std::string& unit, const std::string& si_unit);

/// Is it one of these units?
bool is_empirical_unit(const std::string& unit);

/// Pressure of 1 HV or 1 HB, one kilogram-force per square millimetre of the surface of the indent [Pa].
inline constexpr double kVickersUnit = 9.80665e6;

}  // namespace ringfilm::io
