#pragma once
#include <numbers>

#include "ringfilm/gas_path/pack.hpp"

namespace ringfilm::gas_path {

/// Cylinder pressure like that of a fired engine, with a peak of 50 bar at 15 degree [Pa].
inline models::CyclePressure fired_pressure() {
  std::vector<double> angle, pressure;
  for (int k = 0; k < 720; ++k) {
    const double from_peak = k > 360 ? k - 735.0 : k - 15.0;
    angle.push_back(k);
    pressure.push_back(1e5 * (1 + 49 / (1 + from_peak * from_peak / 1600)));
  }
  return {std::move(angle), std::move(pressure)};
}

/// Two compression rings and an oil ring of a passenger car at 1500 rpm; typical, assumed.
inline Pack two_ring_pack() {
  Ring top;
  top.gap_area = 8e-8;
  top.volume_below = 5e-7;
  top.temperature_below = 450;
  top.groove_volume = 3e-7;
  top.groove_temperature = 500;
  top.side_clearance = 5e-5;
  top.land_clearance = 2e-4;
  top.radial_thickness = 3.5e-3;
  top.face_width = 1.2e-3;
  top.elastic_pressure = 2e5;
  top.mass = 8e-3;
  top.bore_friction_coefficient = 0.05;
  Ring second = top;
  second.volume_below = 3e-7;
  second.temperature_below = 400;
  second.groove_volume = 2e-7;
  second.groove_temperature = 450;
  second.mass = 1e-2;
  Ring oil;
  oil.kind = RingKind::kOil;
  oil.gap_area = 3e-7;
  Pack pack;
  pack.bore = 0.089;
  pack.crank = {0.0795 / 2, 0.1381};
  pack.speed = 1500 * std::numbers::pi / 30;
  pack.chamber = fired_pressure();
  pack.crankcase = models::CyclePressure(101325.0);
  pack.chamber_temperature = 600;
  pack.crankcase_temperature = 360;
  pack.gas = {287, 1.33, 2.5e-5, 0.65, 1e-3};
  pack.sliding_smoothing_speed = 0.05;
  pack.rings = {top, second, oil};
  return pack;
}

}  // namespace ringfilm::gas_path
