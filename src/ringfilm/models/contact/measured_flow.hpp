#pragma once
#include <vector>

/// Flow through the true gap of a measured pair, over the separation of its mean planes
/// (docs/theory/contact-of-measured-pair.md).
namespace ringfilm::models {

/// The factors at separations, as `ringfilm contact --flow-factors` computes them; columns of one length.
struct FlowTable {
  std::vector<double> h;                ///< separations, rising, above 0 [m]
  std::vector<double> pressure_flow_x;  ///< phi_x along the motion, over h^3, eq-flow-cell [-]
  std::vector<double> pressure_flow_y;  ///< phi_y across it [-]
  std::vector<double> shear_flow;       ///< phi_s with the first surface at rest, eq-shear-cell [-]
  std::vector<double> pressure_stress;  ///< phi_fp of the stress by pressure, eq-stress-cell [-]
  std::vector<double> mean_gap;         ///< <H>, not below h [m]
  std::vector<double> gap;              ///< places of the distribution of the true gap, rising [m]
  /// At each separation the share of the area at each of them; the rest of 1 is contact [-].
  std::vector<std::vector<double>> gap_share;
  double sigma = 0;  ///< rms height of both surfaces together [m]

  bool empty() const { return h.empty(); }
};

/// The factors between the rows: cubics with limited slopes. Before the first row they are those of the first; beyond
/// the last one what differs from a smooth gap falls as roughness of second order does, eq-flow-beyond.
class MeasuredFlow {
 public:
  /// Throws InputError for fewer than 2 rows, columns of unequal length, separations that do not rise, shares that are
  /// not of an area.
  explicit MeasuredFlow(FlowTable table);

  /// Factors at separations that are larger by `shift`: the mean gap and the flow of each row are those before the
  /// shift. Rows that move to 0 or below are omitted. Throws InputError where fewer than 2 remain. @param shift [m]
  MeasuredFlow shifted(double shift) const;

  double pressure_flow(double h) const;         ///< phi_x [-]
  double pressure_flow_across(double h) const;  ///< phi_y, for films in two dimensions [-]
  double shear_flow(double h) const;            ///< phi_s, first surface at rest [-]
  double pressure_stress(double h) const;       ///< phi_fp [-]
  double mean_gap(double h) const;              ///< <H> [m]

  /// phi_f: the mean of asinh(S/H) over the open gap, over S/h, eq-sliding-stress-of-gap [-].
  /// @param S viscosity times speed over the Eyring stress, of either sign; 0: 1 [m]
  double sliding_stress(double h, double S) const;
  /// Mean of h/H over the open gap: phi_f of an oil without Eyring's limit [-].
  double mean_inverse_gap(double h) const;

  double sigma() const { return table_.sigma; }      ///< [m]
  double first() const { return table_.h.front(); }  ///< smallest separation of a row [m]
  double last() const { return table_.h.back(); }    ///< largest [m]

 private:
  struct Column {
    std::vector<double> y, slope;  ///< at the rows
  };
  Column column(std::vector<double> values) const;
  double value(const Column& column, double h) const;
  double beyond(double at_last, double power, double h) const;

  FlowTable table_;
  Column x_, y_, shear_, stress_, excess_;
  std::vector<std::vector<double>> sliding_;  ///< <asinh(S/H)>/asinh(S/h) of each row, over places of ln S
};

}  // namespace ringfilm::models
