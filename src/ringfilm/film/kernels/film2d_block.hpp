#pragma once
#include "ringfilm/film/kernels/lane_block.hpp"
#include "ringfilm/film/kernels/zebra.hpp"

/// What the compiled kernels of a two-dimensional film share with their callers: plain numbers. Arrays are zebras
/// (zebra.hpp).
namespace ringfilm::film {

/// A linear system of strips: each node is coupled to its neighbours across and, in the strips beside it, to the nodes
/// at the same place. Rows of nodes that are given and of slots without a strip are those of the identity.
struct StripSystem {
  ZebraShape shape;
  double *west, *diagonal, *east;  ///< by the node before, itself, the node after
  double *low, *high;              ///< by the strips on either side
  double *inverse, *upper;         ///< elimination along each strip
};

/// Newton's iteration of one two-dimensional film.
struct Film2dBlock {
  StripSystem system;  ///< slopes of the balance of mass, in z
  LaneLaws laws;
  LaneCavity cavity;
  Terms terms;
  bool has_steps;  ///< the gap jumps within faces

  // Arrays over the nodes
  double* z;                              ///< eq-film-content, "one number per node" [Pa]
  double* bound;                          ///< lowest pressure over p_c; 0 with Terms::kPlain [Pa]
  double* inflow;                         ///< what the step before left and what sources add [kg/(m s)]
  double* node_height;                    ///< [m]
  double *face_x, *low_face, *high_face;  ///< heights of the faces to the next node across and to the strips beside [m]
  double *face_x_second, *face_x_third, *low_second, *low_third, *high_second, *high_third;  ///< moments about them
  double *rho, *drho_dp, *K, *dK_dp;   ///< filled by the oil kernel, or by the caller with LaneLaws::kGiven
  double *mobility, *mobility_across;  ///< FlowFactors, only with Terms::kAll; so are the next two [-]
  double *stored, *carried;            ///< [m]
  double* column;                      ///< slope of the balance in ln h_m
  /// Parts of `column` by the separation of the strip itself and at the faces to the strips beside; nullptr: not
  /// requested
  double *own_column, *low_column, *high_column;
  double* rhs;       ///< minus the balance
  double* load_row;  ///< slope of the load in z [m]

  // Arrays over the strips
  double* h_m;                                 ///< separation [m]
  double *low_h_m, *high_h_m;                  ///< at the faces to the strips beside: the mean of both [m]
  double* is_strip;                            ///< 1, or 0 where the slot has none
  double* weight;                              ///< share of the length in y, of neighbours that are given too [-]
  double *low_conductance, *high_conductance;  ///< 1/(24 dy) over the share of the strip [1/m2]
  double *flux, *flux_by_left, *flux_by_right, *flux_by_h;  ///< scratch: through the face that was passed last

  // Arrays over the places across the face
  const double* share;        ///< [m]
  const double* conductance;  ///< 1/(24 dx) [1/m]

  double left_supply, right_supply;  ///< four times that of the edges, or kUnlimited [kg/m2]
  double quarter_U, rate, p_cavitation, scale, content_scale;
  double ln_h_scale;  ///< dh/d ln h_m: h_m, the lowest separation [m]
  double start_h;     ///< h_m that weighs the multiplier [m]
  double cavity_K;
  double fit_centre, fit_inverse_half_width;
  const double *fit_K, *fit_dK, *fit_rho, *fit_drho;

  // Outcome
  double load;  ///< mean of p over the length in y, summed across [N/m]
  double largest, peak, check;
  bool to_film, to_cavity;
};

}  // namespace ringfilm::film
