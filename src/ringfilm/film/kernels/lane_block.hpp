#pragma once
#include "ringfilm/film/kernels/balance.hpp"
#include "ringfilm/models/contact/contact_fit.hpp"
#include "ringfilm/models/oil/oil_fit.hpp"

/// What the compiled kernels of the film share with their callers: plain numbers, one film in each lane.
namespace ringfilm::film {

inline constexpr int kMaxLanes = 8;

/// Terms of the polynomials that stand for the laws.
inline constexpr int kFluidityTerms = models::OilFit::kFluidityDegree + 1;
inline constexpr int kFluiditySlopeTerms = models::OilFit::kFluiditySlopeDegree + 1;
inline constexpr int kDensityTerms = models::OilFit::kDensityDegree + 1;
inline constexpr int kDensitySlopeTerms = models::OilFit::kDensitySlopeDegree + 1;
inline constexpr int kContactTerms = models::ContactFit::kDegree + 1;
inline constexpr int kContactSlopeTerms = models::ContactFit::kSlopeDegree + 1;

/// Where oil and contact come from; one choice for all lanes of a block.
enum class LaneLaws {
  kFitted,  ///< from the polynomials in the block
  kGiven,   ///< from `rho` ... `dK_dp` and `contact_load`, `contact_slope`, which the caller fills before every sweep
};

/// How the cavity of a block is closed; one choice for all lanes.
enum class LaneCavity { kFilmContent, kMultiplier };

/// A number for each lane.
using Lanes = double[kMaxLanes];

/// Nodal arrays hold this many more nodes than there are, with no share: nodes are visited several at a time.
inline constexpr int kPadding = 16;

/// Where places lie on cubics of equal pieces (models::ContactPieces).
template <class Real>
struct OnPieces {
  int piece[Real::kWidth];
  Real within;  ///< the piece, 0 to 1

  /// @param places counted in pieces, from 0 to before the end of the last one
  RINGFILM_INLINE explicit OnPieces(Real places) { within = places - places.whole(piece); }

  /// @param cubics(lane) the first coefficient of that lane's first piece @param c lowest power first
  template <class Cubics>
  RINGFILM_INLINE void coefficients(const Cubics& cubics, Real (&c)[4]) const {
    const double* row[Real::kWidth];
    for (int lane = 0; lane < Real::kWidth; ++lane) row[lane] = cubics(lane) + 4 * piece[lane];
    Real::turn_rows(row, c);
  }
  RINGFILM_INLINE Real value(const Real (&c)[4]) const {
    return c[0] + within * (c[1] + within * (c[2] + within * c[3]));
  }
};

/// Newton's iteration of the films in all lanes. Nodal arrays hold the value of node i in lane l at [i * width + l].
struct LaneBlock {
  int n_cells;
  LaneLaws laws;
  LaneCavity cavity;
  Terms terms;

  // Over nodes 0..n
  double* z;  ///< eq-film-content, "one number per node" [Pa]
  // Arrays over the nodes, only with Terms::kAll
  double* bound;                      ///< lowest pressure over p_c [Pa]
  double *mobility, *stored;          ///< FlowFactors [-], [m]
  double* carry;                      ///< argument `carry` of carried_share() [-]
  double* outlet;                     ///< GasReach::outlet [-]
  double* inflow;                     ///< what the step before left and what sources add [kg/(m s)]
  double* node_height;                ///< h_s [m]
  double* share;                      ///< [m]
  double* load_share;                 ///< length on which the pressure of the node acts, only with Terms::kAll [m]
  double *rho, *drho_dp, *K, *dK_dp;  ///< only with LaneLaws::kGiven
  // Over cells 0..n-1
  double* face_height;  ///< h_s [m]
  double* conductance;  ///< 1/(24 dx) [1/m]
  double* carried;      ///< FlowFactors, only with Terms::kAll [m]
  // Scratch over inner nodes
  double *upper, *column, *rhs;

  // Inputs
  alignas(64) Lanes h_m;                   ///< [m]
  alignas(64) Lanes quarter_U;             ///< U/4 [m/s]
  alignas(64) Lanes rate;                  ///< 1/dt, 0 when steady [1/s]
  alignas(64) Lanes p_cavitation;          ///< [Pa]
  alignas(64) Lanes scale, inverse_scale;  ///< scale of pressures and its reciprocal [Pa], [1/Pa]
  alignas(64) Lanes content_scale;         ///< by which z of a cavity is its film content; stays from step to step [Pa]
  alignas(64) Lanes inverse_content_scale;      ///< [1/Pa]
  alignas(64) Lanes load;                       ///< [N/m]
  alignas(64) Lanes left_supply, right_supply;  ///< four times that of the edges, or kUnlimited [kg/m2]
  // Throat: its faces from half a face before the first to half a face after the last, the rest as there
  alignas(64) Lanes throat_begin, throat_end, throat_pressure, throat_reach, throat_place;
  alignas(64) Lanes movable;        ///< 1: h_m is unknown; 0: it is given
  alignas(64) Lanes start_h;        ///< h_m that weighs the multiplier [m]
  alignas(64) Lanes cavity_K;       ///< K at the cavitation pressure [s/m2]
  alignas(64) Lanes contact_load;   ///< W_a where no fit gives it [N/m]
  alignas(64) Lanes contact_slope;  ///< dW_a/dh_m of it [N/m2]

  bool has_outlets;  ///< has any lane had an `outlet` other than 1?

  // Fits
  alignas(64) Lanes fit_centre, fit_inverse_half_width;  ///< [Pa], [1/Pa]
  alignas(64) Lanes fit_K[kFluidityTerms], fit_dK[kFluiditySlopeTerms];
  alignas(64) Lanes fit_rho[kDensityTerms], fit_drho[kDensitySlopeTerms];
  alignas(64) Lanes contact_spread;             ///< 1: contact at the local gap; 0: at h_m on the whole face
  alignas(64) Lanes contact_reach;              ///< beyond this gap there is none; negative: nowhere [m]
  alignas(64) Lanes contact_scale;              ///< scale of the contact pressure [Pa]
  alignas(64) Lanes contact_per_gap;            ///< from the gap to the polynomial's t = -1 ... 1 [1/m]
  bool has_polynomials;                         ///< does any lane have them?
  double contact[kContactTerms];                ///< eighth root of F_5/2 in t
  double contact_slope_of[kContactSlopeTerms];  ///< its slope in t

  // Contact of lanes whose law is cubics on equal pieces (models::ContactPieces)
  bool has_tables;                  ///< does any lane have them?
  const double* table[kMaxLanes];   ///< four coefficients of each piece
  alignas(64) Lanes table_end;      ///< the largest place in the last of them, from 0 at the first
  alignas(64) Lanes table_reach;    ///< beyond this gap there is none; negative: nowhere [m]
  alignas(64) Lanes table_per_gap;  ///< from the gap to the number of the piece [1/m]
  alignas(64) Lanes table_scale;    ///< scale of the contact pressure of the table [Pa]

  // Outcome of a sweep
  alignas(64) Lanes excess;     ///< W_h + W_a - W before the update [N/m]
  alignas(64) Lanes d_ln_h;     ///< by which h_m is to grow; the sweep leaves h_m alone
  alignas(64) Lanes largest;    ///< change of z, relative to the scale or to a larger multiplier
  alignas(64) Lanes peak;       ///< largest z of a film, or 0 [Pa]
  alignas(64) Lanes check;      ///< not finite if anything in the sweep was not
  alignas(64) Lanes to_film;    ///< not 0: a node went from cavity to film
  alignas(64) Lanes to_cavity;  ///< not 0: one went the other way
};

}  // namespace ringfilm::film
