#pragma once
#include "ringfilm/film/lane_block.hpp"

/// One iteration of the coupled Newton method for the films in all lanes of a block, in one pass up the face (oil,
/// fluxes, balance and elimination together, no matrix is stored) and one down (solution and update).
/// docs/theory/film.md, "Newton's method on all of it".
namespace ringfilm::film {

inline constexpr double kLargestFall = -0.916290731874155;  // ln 0.4: trust region in ln h_m
inline constexpr double kLargestRise = 0.916290731874155;   // ln 2.5
inline constexpr double kBlindStep = 0.2;                   // in ln h_m, where the load seems to rise with the film
inline constexpr double kLargestPressureRise = 20;          // scales in one step: the viscosity is exponential in it

template <bool kFirst, class A, class B>
struct Choice {
  using Type = A;
};
template <class A, class B>
struct Choice<false, A, B> {
  using Type = B;
};

/// @tparam Real a pack with a film in each lane
/// @tparam Wide the widest pack of the machine: what has no neighbours is worked out along the face where Real is one
template <class Real, class Wide, LaneLaws kLaws, LaneCavity kCavity>
class NewtonSweep {
  static constexpr int kWidth = Real::kWidth;
  static constexpr bool kAlongFace = kWidth == 1;
  /// Of nodes visited at a time: a lane is a film, or along the face a node.
  using Visitor = typename Choice<kAlongFace, Wide, Real>::Type;
  /// Packs whose polynomials are summed side by side, so that no sum waits for its last term.
  static constexpr int kAbreast = kAlongFace ? 2 : 4;
  static constexpr int kNodesAbreast = kAbreast * Visitor::kWidth / kWidth;
  static_assert(kNodesAbreast <= kPadding);
  using Mask = typename Real::Mask;
  static constexpr bool kFill = kCavity == LaneCavity::kFill;

 public:
  RINGFILM_INLINE explicit NewtonSweep(LaneBlock& block)
      : b_(block),
        h_m_(Real::load(block.h_m)),
        quarter_U_(Real::load(block.quarter_U)),
        p_c_(Real::load(block.p_cavitation)),
        inverse_fill_scale_(Real::load(block.inverse_fill_scale)) {
    const Real to_right = select(quarter_U_ >= Real(0), Real(1), Real(0));
    fill_from_left_ = to_right * quarter_U_ * inverse_fill_scale_;
    fill_from_right_ = (Real(1) - to_right) * quarter_U_ * inverse_fill_scale_;
  }

  RINGFILM_INLINE void run() {
    const Real d_ln_h = forward();
    d_ln_h.store(b_.d_ln_h);
    backward(d_ln_h);
  }

 private:
  /// Nodes that are worked on at a time: few enough that their oil stays in the fastest memory.
  static constexpr int kStretch = 16;

  /// A number for the last node of the stretch before (slot 0) and for each of this one (from slot 1 on).
  struct Stretch {
    alignas(64) double value[(kStretch + 1) * kWidth];
    RINGFILM_INLINE Real at(int slot) const { return Real::load(value + slot * kWidth); }
    RINGFILM_INLINE void put(int slot, Real r) { r.store(value + slot * kWidth); }
    RINGFILM_INLINE void next() { put(0, at(kStretch)); }
  };
  struct Film {
    Stretch p, theta, rho, drho, K, dK;
    RINGFILM_INLINE void next() {
      p.next();
      if constexpr (kFill) theta.next();
      rho.next();
      drho.next();
      K.next();
      dK.next();
    }
  };
  struct Node {
    Real p, theta, rho, drho, K, dK;
  };
  /// Flux through a face and its slopes in z of the two nodes and in h_m.
  struct Flux {
    Real value, by_left, by_right, by_h;
  };

  RINGFILM_INLINE Real at(const double* nodal, int i) const { return Real::load(nodal + i * kWidth); }

  /// A number of each lane, and the nodes from i on in pack `a` of those abreast, as a visitor sees them.
  RINGFILM_INLINE static Visitor of_lanes(const Lanes& x) {
    if constexpr (kAlongFace) {
      return Visitor(x[0]);
    } else {
      return Visitor::load(x);
    }
  }
  RINGFILM_INLINE static Visitor seen(const double* nodal, int i, int a) {
    return Visitor::load(nodal + i * kWidth + a * Visitor::kWidth);
  }
  RINGFILM_INLINE static void put(Visitor value, Stretch& to, int slot, int a) {
    value.store(to.value + slot * kWidth + a * Visitor::kWidth);
  }

  /// Sums of a polynomial at the nodes abreast.
  template <int kTerms>
  RINGFILM_INLINE static void sum(const Lanes* c, const Visitor* t, Stretch& to, int slot) {
    Visitor value[kAbreast];
    const Visitor highest = of_lanes(c[kTerms - 1]);
    for (int a = 0; a < kAbreast; ++a) value[a] = highest;
#pragma GCC unroll 16
    for (int k = kTerms - 2; k >= 0; --k) {
      const Visitor term = of_lanes(c[k]);
      for (int a = 0; a < kAbreast; ++a) value[a] = value[a] * t[a] + term;
    }
    for (int a = 0; a < kAbreast; ++a) put(value[a], to, slot, a);
  }

  /// Pressure, fill, oil and load at the nodes abreast from i on, of which those beyond the edge have no share.
  RINGFILM_INLINE void visit(int i, int slot, Film& film) {
    const Visitor p_c = of_lanes(b_.p_cavitation), inverse_fill_scale = of_lanes(b_.inverse_fill_scale);
    const Visitor centre = of_lanes(b_.fit_centre), per_pressure = of_lanes(b_.fit_inverse_half_width);
    Visitor t[kAbreast];
    for (int a = 0; a < kAbreast; ++a) {
      const Visitor z = seen(b_.z, i, a);
      const Visitor p = p_c + max(Visitor(0), z);
      put(p, film.p, slot, a);
      if constexpr (kFill) put(Visitor(1) + min(Visitor(0), z) * inverse_fill_scale, film.theta, slot, a);
      load_ += seen(b_.share, i, a) * p;
      t[a] = min(Visitor(1), (p - centre) * per_pressure);
    }
    if constexpr (kLaws == LaneLaws::kFitted) {
      sum<kFluidityTerms>(b_.fit_K, t, film.K, slot);
      sum<kFluiditySlopeTerms>(b_.fit_dK, t, film.dK, slot);
      sum<kDensityTerms>(b_.fit_rho, t, film.rho, slot);
      sum<kDensitySlopeTerms>(b_.fit_drho, t, film.drho, slot);
      add_contact(i);
    } else {
      for (int a = 0; a < kAbreast; ++a) {
        put(seen(b_.K, i, a), film.K, slot, a);
        put(seen(b_.dK_dp, i, a), film.dK, slot, a);
        put(seen(b_.rho, i, a), film.rho, slot, a);
        put(seen(b_.drho_dp, i, a), film.drho, slot, a);
      }
    }
  }

  /// Adds the load of the asperities at the nodes abreast from i on, and its slope in h_m.
  RINGFILM_INLINE void add_contact(int i) {
    const Visitor h_m = of_lanes(b_.h_m), spread = of_lanes(b_.contact_spread), reach = of_lanes(b_.contact_reach);
    Visitor gap[kAbreast], least(1e300);
    for (int a = 0; a < kAbreast; ++a) {
      gap[a] = h_m + spread * seen(b_.node_height, i, a);
      least = min(least, gap[a]);
    }
    if (!Visitor::any(least < reach)) return;
    const Visitor per_gap = of_lanes(b_.contact_per_gap);
    Visitor lowest[kAbreast], t[kAbreast], root[kAbreast], root_slope[kAbreast];
    for (int a = 0; a < kAbreast; ++a) {
      lowest[a] = max(Visitor(0), gap[a]);  // below no gap load and slope go on along the tangent
      // Lanes out of reach count for nothing, but must be numbers.
      t[a] = min(Visitor(1), lowest[a] * per_gap - Visitor(1));
    }
    base::sum_of_powers<kContactTerms, kAbreast>(b_.contact, t, root);
    base::sum_of_powers<kContactSlopeTerms, kAbreast>(b_.contact_slope_of, t, root_slope);
    const Visitor scale = of_lanes(b_.contact_scale);
    for (int a = 0; a < kAbreast; ++a) {
      const Visitor square = root[a] * root[a];
      const Visitor fourth = square * square;
      const Visitor dF = Visitor(8) * fourth * square * root[a] * root_slope[a] * per_gap;
      const Visitor F = fourth * fourth + dF * (gap[a] - lowest[a]);
      const Visitor weight = select(gap[a] < reach, seen(b_.share, i, a) * scale, Visitor(0));
      load_ += weight * F;
      slope_ += weight * dF;
    }
  }

  RINGFILM_INLINE Node node(const Film& film, int k) const {
    return {film.p.at(k), kFill ? film.theta.at(k) : Real(1), film.rho.at(k), film.drho.at(k), film.K.at(k),
            film.dK.at(k)};
  }

  RINGFILM_INLINE Flux flux(int face, const Node& left, Mask left_is_film, const Node& right,
                            Mask right_is_film) const {
    const Real h = h_m_ + at(b_.face_height, face);
    const Real square = h * h * at(b_.conductance, face);
    const Real conductance = square * h;
    const Real K = left.K + right.K;
    const Real rho = left.rho + right.rho;
    const Real dp = right.p - left.p;
    const Real upwind = kFill ? quarter_U_ * select(quarter_U_ >= Real(0), left.theta, right.theta) : quarter_U_;
    const Real couette = upwind * h;
    const Real gradient = K * dp;

    Flux flux;
    flux.value = couette * rho - conductance * gradient;
    const Real film_left = couette * left.drho + conductance * (K - left.dK * dp);
    const Real film_right = couette * right.drho - conductance * (K + right.dK * dp);
    if constexpr (kFill) {
      const Real stream = h * rho;
      flux.by_left = select(left_is_film, film_left, fill_from_left_ * stream);
      flux.by_right = select(right_is_film, film_right, fill_from_right_ * stream);
    } else {
      flux.by_left = select(left_is_film, film_left, Real(0));
      flux.by_right = select(right_is_film, film_right, Real(0));
    }
    flux.by_h = upwind * rho - Real(3) * square * gradient;
    return flux;
  }

  /// Balance of mass and load, eliminated down to one equation for ln h_m; returns its solution.
  RINGFILM_INLINE Real forward() {
    const int n = b_.n_cells;
    load_ = slope_ = Visitor(0);
    const Real rate = Real::load(b_.rate), left_h = Real::load(b_.left_h);
    const Mask goes_on = Real::load(b_.goes_on) > Real(0);
    const bool some_go_on = Real::any(goes_on);
    Real row(0), upper(0), column(0), rhs(0);  // of the node before, eliminated
    Real by_column(0), by_rhs(0);              // what the elimination takes off the load row

    Film film;
    Flux in;
    for (int begin = 0; begin <= n; begin += kStretch) {
      for (int a = 0; a < kStretch && begin + a <= n; a += kNodesAbreast) visit(begin + a, 1 + a, film);
      if (begin == 0) {
        in = flux(0, node(film, 1), at(b_.z, 0) > Real(0), node(film, 2), at(b_.z, 1) > Real(0));
        in.by_left = Real(0);  // the edge is given
      }
      const int last = begin + kStretch - 2 < n - 1 ? begin + kStretch - 2 : n - 1;  // whose right neighbour is known
      for (int i = begin == 0 ? 1 : begin - 1; i <= last; ++i) {
        const int slot = i - begin + 1;
        const Node here = node(film, slot);
        const Real z = at(b_.z, i);
        const Mask here_is_film = z > Real(0);
        const Flux out = flux(i, here, here_is_film, node(film, slot + 1), at(b_.z, i + 1) > Real(0));
        const Real height = at(b_.node_height, i);
        const Real share = at(b_.share, i);
        const Real h = h_m_ + height;
        const Real volume = share * rate;
        const Real stored = volume * h;  // times rho theta
        const Real filled = kFill ? here.rho * here.theta : here.rho;
        Real inflow = at(b_.inflow, i);
        if (some_go_on) {
          inflow = select(goes_on, volume * (filled * (left_h + height)), inflow);
          inflow.store(b_.inflow + i * kWidth);
        }
        Real residual = stored * filled - inflow + (out.value - in.value);
        Real diagonal = out.by_left - in.by_right;
        if constexpr (kFill) {
          diagonal += stored * select(here_is_film, here.drho, here.rho * inverse_fill_scale_);
        } else {
          const Real gap = Real::load(b_.start_h) + height;
          const Real weight = Real(2) * (at(b_.conductance, i - 1) + at(b_.conductance, i)) * (gap * gap * gap) *
                              Real::load(b_.cavity_K);
          diagonal = select(here_is_film, diagonal + stored * here.drho, weight);
          residual += weight * min(Real(0), z);
        }
        const Real by_h = (volume * filled + (out.by_h - in.by_h)) * h_m_;

        const Real pivot = diagonal + in.by_left * upper;
        const Mask inside = at(b_.conductance, i) > Real(0);  // beyond its last cell a shorter film has no equation
        const Real inverse = select(inside, Real(1) / select(inside, pivot, Real(1)), Real(0));
        row = select(here_is_film, share, Real(0)) - row * upper;
        upper = out.by_right * inverse;
        column = (by_h + in.by_left * column) * inverse;
        rhs = (in.by_left * rhs - residual) * inverse;
        by_column += row * column;
        by_rhs += row * rhs;
        upper.store(b_.upper + i * kWidth);
        column.store(b_.column + i * kWidth);
        rhs.store(b_.rhs + i * kWidth);
        in = out;
      }
      film.next();
    }
    Real excess = Real::load(b_.contact_load) - Real::load(b_.load);
    Real slope = Real::load(b_.contact_slope);
    if constexpr (kAlongFace) {
      excess += Real(load_.sum());
      slope += Real(slope_.sum());
    } else {
      excess += load_;
      slope += slope_;
    }
    excess.store(b_.excess);

    // The load carried must fall with h_m; where the linearisation says otherwise, only its sign is believed.
    const Real corner = slope * h_m_ - by_column;
    check_ = corner + by_rhs + at(b_.z, 0) + at(b_.z, n);
    const Real newton = (-excess - by_rhs) / select(corner < Real(0), corner, Real(-1));
    const Real blind = select(excess < Real(0), Real(-kBlindStep), Real(kBlindStep));
    const Real step = select(corner < Real(0), newton, blind);
    const Real limited = min(max(step, Real(kLargestFall)), Real(kLargestRise));
    return select(Real::load(b_.movable) > Real(0), limited, Real(0));
  }

  /// z moves by the Newton step, but a node that would change sides stops just beyond the kink: there the linearisation
  /// is that of the other side.
  RINGFILM_INLINE void backward(Real d_ln_h) {
    const Real scale = Real::load(b_.scale);
    const Real inverse_scale = Real::load(b_.inverse_scale);
    const Real beyond = Real(kBeyondKink) * scale;
    const Real hardly_empty = Real(kBeyondKink) * Real::load(b_.fill_scale);
    const Real most = Real(kLargestPressureRise) * scale;
    Real largest(0), peak(0), to_film(0), to_cavity(0);
    Real step(0);
    for (int i = b_.n_cells - 1; i > 0; --i) {
      step = at(b_.rhs, i) - at(b_.column, i) * d_ln_h - at(b_.upper, i) * step;
      const Real before = at(b_.z, i);
      const Mask was_film = before > Real(0);
      Real after = before + select(was_film, min(step, most), step);
      const Mask is_film = after > Real(0);
      if (Real::any(Real::differ(is_film, was_film))) {
        const Mask entered = Real::only(is_film, was_film);
        const Mask left = Real::only(was_film, is_film);
        to_film = select(Real::both(entered, after > beyond), Real(1), to_film);
        to_cavity = select(Real::both(left, after < -hardly_empty), Real(1), to_cavity);
        after = select(entered, beyond, select(left, -hardly_empty, after));
      }
      Real change =
          abs(after - before) * (kFill ? select(was_film, inverse_scale, inverse_fill_scale_) : inverse_scale);
      if constexpr (!kFill) {
        const Mask above = -after > scale;
        if (Real::any(above)) change = select(above, abs(after - before) / max(-after, scale), change);
      }
      largest = max(largest, change);  // a NaN here is one in check_ as well
      check_ += after;
      peak = max(peak, after);
      after.store(b_.z + i * kWidth);
    }
    largest.store(b_.largest);
    check_.store(b_.check);
    peak.store(b_.peak);
    to_film.store(b_.to_film);
    to_cavity.store(b_.to_cavity);
  }

  LaneBlock& b_;
  Real h_m_, quarter_U_, p_c_, inverse_fill_scale_;
  Real fill_from_left_, fill_from_right_;
  Visitor load_, slope_;  ///< W_h + W_a, and the slope of W_a in h_m, as far as visited
  Real check_;
};

}  // namespace ringfilm::film
