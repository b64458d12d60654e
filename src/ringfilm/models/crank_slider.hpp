#pragma once

/// How piston and ring move (docs/theory/kinematics.md).
namespace ringfilm::models {

/// Kinematics of the piston; eq-piston-velocity. Crank angle phi [rad], 0 = TDC. Velocity is positive towards TDC.
struct CrankSlider {
  double crank_radius;           ///< r [m]
  double connecting_rod_length;  ///< l [m], longer than r

  /// Distance below the TDC position [m].
  double position(double phi) const;

  /// U_p [m/s] at the engine speed omega [rad/s].
  double velocity(double phi, double omega) const;

  /// Acceleration of the piston at the engine speed omega, positive towards TDC, eq-piston-acceleration [m/s2].
  double acceleration(double phi, double omega) const;

  /// Distance between the dead centres [m].
  double stroke() const { return 2 * crank_radius; }
};

}  // namespace ringfilm::models
