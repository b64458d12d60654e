#pragma once
#include <functional>
#include <vector>

/// Shape of the ring face and tension of the ring (docs/theory/ring.md).
namespace ringfilm::models {

/// Gap of the ring face to a straight line, h_s(x), 0 <= x <= b, counted from the zero of its source: the running
/// surface is low, the edges are high. What lies above the lowest point is height(x) - minimum().height.
class RingFace {
 public:
  /// h_s(x) = height_unit * sum_k coefficients[k] (x/length_unit)^(n-1-k), eq-face-polynomial.
  static RingFace polynomial(std::vector<double> coefficients, double length_unit, double height_unit,
                             double face_width);
  /// Parabola with its lowest point at apex * b and height `crown_height` at the edge farther from it.
  static RingFace parabola(double crown_height, double apex, double face_width);
  /// One period of a cosine with its lowest point, zero, at apex * b and its highest at `crown_height`.
  static RingFace cosine(double crown_height, double apex, double face_width);
  /// Measured points, linear between them: no shape is invented. x [m] increasing, covers 0 to b; else InputError.
  static RingFace points(std::vector<double> x, std::vector<double> height, double face_width);

  double height(double x) const;                     ///< as given, without taking the minimum off [m]
  double face_width() const { return face_width_; }  ///< b [m]

  /// True minimum over the face (not only over sample points) and where it lies.
  struct Minimum {
    double x;       ///< [m]
    double height;  ///< [m]
  };
  Minimum minimum() const;  ///< lowest point of the face

  /// x -> b - x.
  RingFace turned() const;

 private:
  RingFace(std::function<double(double)> height, double face_width, std::vector<double> break_points);

  std::function<double(double)> height_;
  double face_width_;
  std::vector<double> break_points_;  ///< from 0 to b; at the inner ones the slope may jump, or the lowest point is
};

/// Ring pressing on the bore: p_e = 2 F_t/(b B), eq-elastic-pressure [Pa].
double elastic_pressure_from_tangential_force(double F_t, double face_width, double bore);
/// The inverse, F_t = p_e b B/2 [N].
double tangential_force_from_elastic_pressure(double p_e, double face_width, double bore);
/// p_e = E t^3 s/(36 pi r^4), r = bore/2, eq-elastic-pressure-gap [Pa].
double elastic_pressure_from_free_gap(double free_gap, double radial_thickness, double E, double bore);
/// Of any section: p_e = E I s/(3 pi b r^4), r = bore/2. @param second_moment I, for bending in the ring's plane [m4]
double elastic_pressure_from_section(double free_gap, double second_moment, double face_width, double E, double bore);

}  // namespace ringfilm::models
