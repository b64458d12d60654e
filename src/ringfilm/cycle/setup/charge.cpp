#include "ringfilm/cycle/setup/charge.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ringfilm/cycle/setup/gas_mixture.hpp"
#include "ringfilm/cycle/setup/kinematics.hpp"
#include "ringfilm/cycle/setup/setup.hpp"
#include "ringfilm/models/gas/heat_transfer.hpp"

namespace ringfilm::cycle {
namespace {

constexpr double kGasExchangeTdcDeg = 360;

double piston_area(double bore) { return std::numbers::pi / 4 * bore * bore; }

}  // namespace

Charge::Charge(const Case& c)
    : crank_(crank_slider(c)),
      pressure_(cylinder_pressure(c)),
      bore_(c.engine.bore),
      clearance_volume_(piston_area(c.engine.bore) * c.engine.stroke / (c.gas.compression_ratio - 1)),
      mean_piston_speed_(c.engine.stroke * c.operating.speed / std::numbers::pi),
      gas_constant_(gas_properties(c).gas_constant),
      heat_capacity_ratio_(gas_properties(c).heat_capacity_ratio),
      intake_closes_deg_(c.gas.intake_valve_closing_deg),
      exhaust_opens_deg_(c.gas.exhaust_valve_opening_deg),
      charge_temperature_(c.gas.charge_temperature),
      mass_(pressure_.pressure(intake_closes_deg_) * volume(intake_closes_deg_) /
            (gas_constant_ * charge_temperature_)) {}

double Charge::volume(double angle_deg) const {
  return clearance_volume_ + piston_area(bore_) * crank_.position(radians(angle_deg));
}

bool Charge::is_closed(double angle_deg) const {
  return angle_deg <= exhaust_opens_deg_ || angle_deg >= intake_closes_deg_;
}

double Charge::temperature(double angle_deg) const {
  const double angle = wrapped(angle_deg);
  const auto of_volume = [this](double at) { return pressure(at) * volume(at) / (mass_ * gas_constant_); };
  if (is_closed(angle)) return of_volume(angle);
  if (angle >= kGasExchangeTdcDeg) return charge_temperature_;
  const double exponent = (heat_capacity_ratio_ - 1) / heat_capacity_ratio_;
  return of_volume(exhaust_opens_deg_) * std::pow(pressure(angle) / pressure(exhaust_opens_deg_), exponent);
}

double Charge::heat_transfer_coefficient(double angle_deg) const {
  const double angle = wrapped(angle_deg), p = pressure(angle);
  double velocity = models::kWoschniGasExchange * mean_piston_speed_;
  if (is_closed(angle)) {
    velocity = models::kWoschniClosed * mean_piston_speed_;
    if (angle <= exhaust_opens_deg_) {
      const double p_closing = pressure(intake_closes_deg_), V_closing = volume(intake_closes_deg_);
      const double motored = p_closing * std::pow(V_closing / volume(angle), heat_capacity_ratio_);
      const double swept = piston_area(bore_) * crank_.stroke();
      velocity += models::kWoschniCombustion * swept * charge_temperature_ / (p_closing * V_closing) *
                  std::max(p - motored, 0.0);
    }
  }
  return models::woschni_coefficient(bore_, p, temperature(angle), velocity);
}

}  // namespace ringfilm::cycle
