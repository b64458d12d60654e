#pragma once
#include <optional>
#include <vector>

/// Shapes of bore, ring and pad as a case states them.
namespace ringfilm::cycle {

/// One term of a series around the bore, amplitude cos(order (angle - phase)).
struct FourierTerm {
  int order = 0;
  double amplitude = 0;          ///< [unit of the key]
  double phase_deg = 0;          ///< phase of a crest [degree]
  std::optional<double> height;  ///< along the stroke, where the bore changes with it [m]
};

/// Deviation of the bore's radius on a grid, angles evenly spaced over one turn.
struct BoreMap {
  std::vector<double> height;                  ///< increasing [m]
  double first_angle_deg = 0;                  ///< first angle of each row [degree]
  std::vector<std::vector<double>> deviation;  ///< a row of one height each [m]
};

/// Deviation of the bore's radius at the place of a ring, over the crank angle.
struct DynamicBore {
  std::vector<double> crank_angle_deg;         ///< increasing, within [0, 720), 0 = firing TDC [degree]
  double first_angle_deg = 0;                  ///< first angle of each row [degree]
  std::vector<std::vector<double>> deviation;  ///< a row of one crank angle each [m]
};

/// Running surface of a free ring in polar coordinates about any centre, from one end to the other.
struct FreeRing {
  std::vector<double> angle_deg;  ///< increasing [degree]
  std::vector<double> radius;     ///< [m]
};

/// Pressure of a ring on a round bore at angles from the gap's middle, evenly spaced over one turn.
struct PressurePoints {
  double first_angle_deg = 0;    ///< [degree]
  std::vector<double> pressure;  ///< [Pa]
};

/// The keys under `pad.grooves`: grooves over the whole width of a gap by a formula.
struct PadGrooves {
  std::vector<double> positions;  ///< middles as fractions of the length, increasing; empty: no grooves [-]
  double width = 0;               ///< along x [m]
  double depth = 0;               ///< added to the gap [m]
};

}  // namespace ringfilm::cycle
