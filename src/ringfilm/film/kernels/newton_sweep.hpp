#pragma once
#include <type_traits>

#include "ringfilm/film/kernels/lane_block.hpp"

/// One iteration of the coupled Newton method for the films in all lanes of a block, in one pass up the face (oil,
/// fluxes, balance and elimination together, no matrix is stored) and one down (solution and update).
/// docs/theory/film.md, "Newton's method on film and separation".
namespace ringfilm::film {

inline constexpr double kMaxFall = -0.916290731874155;  // ln 0.4: trust region in ln h_m
inline constexpr double kMaxRise = 0.916290731874155;   // ln 2.5
inline constexpr double kSignOnlyStep = 0.2;            // in ln h_m, where the load seems to rise with the film

/// @tparam Real a pack with a film in each lane
/// @tparam Wide the widest pack of the machine: what has no neighbours is worked out along the face where Real is one
template <class Real, class Wide, LaneLaws kLaws, LaneCavity kCavity, Terms kTerms>
class NewtonSweep {
  static constexpr int kWidth = Real::kWidth;
  static constexpr bool kAlongFace = kWidth == 1;
  /// Pack of nodes that are visited together: a lane is a film, or a node along the face.
  using Visitor = std::conditional_t<kAlongFace, Wide, Real>;
  /// Packs whose polynomials are summed side by side, so that no sum waits for its last term.
  static constexpr int kAbreast = kAlongFace ? 2 : 4;
  static constexpr int kNodesAbreast = kAbreast * Visitor::kWidth / kWidth;
  static_assert(kNodesAbreast <= kPadding);
  using Mask = typename Real::Mask;
  static constexpr bool kFilmContent = kCavity == LaneCavity::kFilmContent;

 public:
  RINGFILM_INLINE explicit NewtonSweep(LaneBlock& block)
      : b_(block),
        h_m_(Real::load(block.h_m)),
        inverse_content_scale_(Real::load(block.inverse_content_scale)),
        motion_(Real::load(block.quarter_U), inverse_content_scale_) {}

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
      if constexpr (kFilmContent) theta.next();
      rho.next();
      drho.next();
      K.next();
      dK.next();
    }
  };
  using Node = film::Node<Real>;
  using Flux = film::Flux<Real>;

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
  template <int kCoefficients>
  RINGFILM_INLINE static void sum(const Lanes* c, const Visitor* t, Stretch& to, int slot) {
    Visitor value[kAbreast];
    const Visitor highest = of_lanes(c[kCoefficients - 1]);
    for (int a = 0; a < kAbreast; ++a) value[a] = highest;
#pragma GCC unroll 16
    for (int k = kCoefficients - 2; k >= 0; --k) {
      const Visitor term = of_lanes(c[k]);
      for (int a = 0; a < kAbreast; ++a) value[a] = value[a] * t[a] + term;
    }
    for (int a = 0; a < kAbreast; ++a) put(value[a], to, slot, a);
  }

  /// Pressure, film content, oil and load at the nodes abreast from i on, of which those beyond the edge have no share.
  RINGFILM_INLINE void visit(int i, int slot, Film& film) {
    const Visitor p_c = of_lanes(b_.p_cavitation), inverse_content_scale = of_lanes(b_.inverse_content_scale);
    const Visitor centre = of_lanes(b_.fit_centre), per_pressure = of_lanes(b_.fit_inverse_half_width);
    Visitor t[kAbreast];
    for (int a = 0; a < kAbreast; ++a) {
      const Visitor z = seen(b_.z, i, a);
      Visitor p = p_c + max(Visitor(0), z);
      if constexpr (kTerms == Terms::kAll) p += seen(b_.bound, i, a);
      put(p, film.p, slot, a);
      if constexpr (kFilmContent) put(Visitor(1) + min(Visitor(0), z) * inverse_content_scale, film.theta, slot, a);
      load_ += seen(kTerms == Terms::kAll ? b_.load_share : b_.share, i, a) * p;
      t[a] = min(Visitor(1), (p - centre) * per_pressure);
    }
    if constexpr (kLaws == LaneLaws::kFitted) {
      sum<kFluidityTerms>(b_.fit_K, t, film.K, slot);
      sum<kFluiditySlopeTerms>(b_.fit_dK, t, film.dK, slot);
      sum<kDensityTerms>(b_.fit_rho, t, film.rho, slot);
      sum<kDensitySlopeTerms>(b_.fit_drho, t, film.drho, slot);
      if (b_.has_polynomials) add_contact(i);
      if (b_.has_tables) add_tabulated_contact(i);
    } else {
      for (int a = 0; a < kAbreast; ++a) {
        put(seen(b_.K, i, a), film.K, slot, a);
        put(seen(b_.dK_dp, i, a), film.dK, slot, a);
        put(seen(b_.rho, i, a), film.rho, slot, a);
        put(seen(b_.drho_dp, i, a), film.drho, slot, a);
      }
    }
    if constexpr (kTerms == Terms::kAll) {
      for (int a = 0; a < kAbreast; ++a) {
        for (Stretch* of : {&film.K, &film.dK}) {
          double* at = of->value + slot * kWidth + a * Visitor::kWidth;
          (Visitor::load(at) * seen(b_.mobility, i, a)).store(at);
        }
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
      lowest[a] = max(Visitor(0), gap[a]);
      // Lanes out of reach count for nothing, but must be numbers.
      t[a] = min(Visitor(1), lowest[a] * per_gap - Visitor(1));
    }
    base::sum_of_powers<kContactTerms, kAbreast>(b_.contact, t, root);
    base::sum_of_powers<kContactSlopeTerms, kAbreast>(b_.contact_slope_of, t, root_slope);
    const Visitor scale = of_lanes(b_.contact_scale);
    for (int a = 0; a < kAbreast; ++a) {
      const Visitor weight = select(gap[a] < reach, seen(b_.share, i, a) * scale, Visitor(0));
      add_asperity_load(weight, root[a], root_slope[a], per_gap, gap[a] - lowest[a]);
    }
  }

  /// Adds the contact of lanes whose law is a table.
  RINGFILM_INLINE void add_tabulated_contact(int i) {
    const Visitor h_m = of_lanes(b_.h_m), spread = of_lanes(b_.contact_spread), reach = of_lanes(b_.table_reach);
    const Visitor per_gap = of_lanes(b_.table_per_gap), scale = of_lanes(b_.table_scale);
    const Visitor end = of_lanes(b_.table_end);
    for (int a = 0; a < kAbreast; ++a) {
      const Visitor gap = h_m + spread * seen(b_.node_height, i, a);
      if (!Visitor::any(gap < reach)) continue;
      const Visitor lowest = max(Visitor(0), gap);
      const Visitor place = min(lowest * per_gap, end);  // a NaN is there
      const OnPieces<Visitor> on(place);
      Visitor c[4];
      on.coefficients([&](int lane) RINGFILM_INLINE_BODY { return b_.table[kAlongFace ? 0 : lane]; }, c);
      const Visitor root_slope = c[1] + on.within * (c[2] + c[2] + Visitor(3) * on.within * c[3]);
      const Visitor weight = select(gap < reach, seen(b_.share, i, a) * scale, Visitor(0));
      add_asperity_load(weight, on.value(c), root_slope, per_gap, gap - lowest);
    }
  }

  /// Asperity load of one pack of nodes. @param weight share of the face times the scale of the pressure; 0: out of
  /// reach
  /// @param root eighth root of the pressure  @param root_slope its slope in the argument of the law
  /// @param below part of the gap below 0, where load continues along its tangent
  RINGFILM_INLINE void add_asperity_load(Visitor weight, Visitor root, Visitor root_slope, Visitor per_gap,
                                         Visitor below) {
    const Visitor square = root * root, fourth = square * square;
    const Visitor dF = Visitor(8) * fourth * square * root * root_slope * per_gap;
    load_ += weight * (fourth * fourth + dF * below);
    slope_ += weight * dF;
  }

  /// Node `i`, in slot `k` of its stretch.
  RINGFILM_INLINE Node node(const Film& film, int i, int k) const {
    const Real filled = kFilmContent ? film.theta.at(k) : Real(1);
    Node node{film.p.at(k), filled,        film.rho.at(k),        film.drho.at(k),
              film.K.at(k), film.dK.at(k), at(b_.z, i) > Real(0), filled};
    if constexpr (kFilmContent && kTerms == Terms::kAll) {
      const Real carry = at(b_.carry, i);
      node.theta = carried_share(filled, carry);
      node.gain = select(carry * filled < Real(1), carry, select(carry > Real(kBetweenWalls), Real(0), Real(1)));
      if (b_.has_outlets) let_hang(at(b_.outlet, i), node);
    }
    return node;
  }

  RINGFILM_INLINE Flux flux(int face, const Node& left, const Node& right) const {
    const Real h = h_m_ + at(b_.face_height, face);
    const Real third = h * h * at(b_.conductance, face);
    Real upstream = h;
    if constexpr (kFilmContent) {
      upstream = h_m_ + motion_.upstream(at(b_.node_height, face), at(b_.node_height, face + 1));
    }
    if constexpr (kTerms == Terms::kAll) {
      const Real beyond = at(b_.carried, face), carried = h + beyond;
      Flux flux = film::flux(motion_, carried, upstream + beyond, third * h, third, left, right);
      if constexpr (kFilmContent) hold_back(face, carried, upstream + beyond, third * h, third, left, right, flux);
      if (face == 0) limit_inlet(carried, Real(1), Real::load(b_.left_supply), left, right, flux);
      limit_right(face, carried, left, right, flux);
      return flux;
    } else {
      return film::flux(motion_, h, upstream, third * h, third, left, right);
    }
  }

  /// Films of a block may end at different faces: at the last one the conductance is not 0, and after it it is.
  RINGFILM_INLINE Mask is_last(int face) const {
    return Real::only(at(b_.conductance, face) > Real(0), at(b_.conductance, face + 1) > Real(0));
  }

  RINGFILM_INLINE void hold_back(int face, Real carried, Real upstream, Real conductance, Real third, const Node& left,
                                 const Node& right, Flux& flux) const {
    const Mask at_throat = Real::both(Real(face) > Real::load(b_.throat_begin), Real::load(b_.throat_end) > Real(face));
    if (!Real::any(at_throat)) return;
    const Real edge_left = face == 0 ? Real(0) : left.filled, edge_right = select(is_last(face), Real(0), right.filled);
    const Real carry = motion_.upstream(at(b_.carry, face + 1), at(b_.carry, face));
    const Real least = select(carry > Real(kBetweenWalls), Real(kPressingOnWall), Real(kPressingBetweenWalls));
    film::hold_back(motion_, at_throat, Real::load(b_.throat_pressure), Real::load(b_.throat_reach),
                    Real::load(b_.throat_place), motion_.upstream(edge_right, edge_left), least, carried, upstream,
                    conductance, third, left, right, flux);
  }

  RINGFILM_INLINE void limit_right(int face, Real carried, const Node& left, const Node& right, Flux& flux) const {
    const Real supply = Real::load(b_.right_supply);
    if (!Real::any(supply < Real(kUnlimited))) return;
    const Mask last = is_last(face);
    if (!Real::any(last)) return;
    limit_inlet(carried, Real(-1), select(last, supply, Real(kUnlimited)), left, right, flux);
  }

  RINGFILM_INLINE void limit_inlet(Real carried, Real inward, Real supply, const Node& left, const Node& right,
                                   Flux& flux) const {
    const Mask is_steady = Real(0) >= Real::load(b_.rate);
    film::limit_inlet(motion_.quarter_U, carried, inward, supply, is_steady, left, right, flux);
  }

  /// Balance of mass and load, eliminated down to one equation for ln h_m; returns its solution.
  RINGFILM_INLINE Real forward() {
    const int n = b_.n_cells;
    load_ = slope_ = Visitor(0);
    const Real rate = Real::load(b_.rate);
    Real row(0), upper(0), column(0), rhs(0);  // row of the node before, eliminated
    Real by_column(0), by_rhs(0);              // what the elimination subtracts from the load row

    Film film;
    Flux in;
    for (int begin = 0; begin <= n; begin += kStretch) {
      for (int a = 0; a < kStretch && begin + a <= n; a += kNodesAbreast) visit(begin + a, 1 + a, film);
      if (begin == 0) {
        in = flux(0, node(film, 0, 1), node(film, 1, 2));
        in.by_left = Real(0);  // the edge is given
      }
      const int last = begin + kStretch - 2 < n - 1 ? begin + kStretch - 2 : n - 1;  // whose right neighbour is known
      for (int i = begin == 0 ? 1 : begin - 1; i <= last; ++i) {
        const int slot = i - begin + 1;
        const Node here = node(film, i, slot);
        const Flux out = flux(i, here, node(film, i + 1, slot + 1));
        const Real height = at(b_.node_height, i);
        const Real share = at(b_.share, i);
        const Real h = h_m_ + height;
        const Real volume = share * rate;
        Real stored = volume * h;  // times rho theta
        if constexpr (kTerms == Terms::kAll) stored += volume * at(b_.stored, i);
        const Real filled = filled_density<kFilmContent>(here);
        Real residual = stored * filled - at(b_.inflow, i) + (out.value - in.value);
        Real diagonal = out.by_left - in.by_right;
        if constexpr (kFilmContent) {
          diagonal += stored * filled_density_slope(here, inverse_content_scale_);
        } else {
          const Real gap = Real::load(b_.start_h) + height;
          const Real weight =
              multiplier_weight(at(b_.conductance, i - 1) + at(b_.conductance, i), gap, Real::load(b_.cavity_K));
          diagonal = select(here.is_film, diagonal + stored * here.drho, weight);
          residual += weight * min(Real(0), at(b_.z, i));
        }
        const Real by_h = (volume * filled + (out.by_h - in.by_h)) * h_m_;

        Real pivot = diagonal + in.by_left * upper;
        const Mask inside = at(b_.conductance, i) > Real(0);  // beyond its last cell a shorter film has no equation
        // A node that neither flow nor storage determines keeps its value if it is in balance. Else it moves by the
        // scale of the pressure, so that the iteration does not end there. A branch, since the pivot is waited for.
        const Mask undetermined = Real(0) >= abs(pivot);
        if (Real::any(undetermined)) {
          const Real forced = select(abs(residual) > Real(0), residual * Real::load(b_.inverse_scale), Real(1));
          pivot = select(undetermined, forced, pivot);
        }
        const Real inverse = select(inside, Real(1) / select(inside, pivot, Real(1)), Real(0));
        row = select(here.is_film, kTerms == Terms::kAll ? at(b_.load_share, i) : share, Real(0)) - row * upper;
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

    // The load carried must fall with h_m; where the linearisation gives a rise, only the sign of the excess is used.
    const Real corner = slope * h_m_ - by_column;
    check_ = corner + by_rhs + at(b_.z, 0) + at(b_.z, n);
    const Real newton = (-excess - by_rhs) / select(corner < Real(0), corner, Real(-1));
    const Real sign_only = select(excess < Real(0), Real(-kSignOnlyStep), Real(kSignOnlyStep));
    const Real step = select(corner < Real(0), newton, sign_only);
    const Real limited = min(max(step, Real(kMaxFall)), Real(kMaxRise));
    return select(Real::load(b_.movable) > Real(0), limited, Real(0));
  }

  RINGFILM_INLINE void backward(Real d_ln_h) {
    KinkStep<Real> kink{Real::load(b_.scale), Real::load(b_.inverse_scale), Real::load(b_.content_scale),
                        inverse_content_scale_};
    Real peak(0), step(0);
    for (int i = b_.n_cells - 1; i > 0; --i) {
      step = at(b_.rhs, i) - at(b_.column, i) * d_ln_h - at(b_.upper, i) * step;
      Real after = kink.template take<kFilmContent>(at(b_.z, i), step);
      // Pressure drives out of a node the oil that it has: with less than none it would drive it the other way.
      if constexpr (kFilmContent && kTerms == Terms::kAll) after = max(after, -kink.content_scale);
      check_ += after;  // a NaN of `largest` is one here as well
      if constexpr (kTerms == Terms::kAll) {
        peak = max(peak, max(Real(0), after) + at(b_.bound, i));
      } else {
        peak = max(peak, after);
      }
      after.store(b_.z + i * kWidth);
    }
    kink.largest.store(b_.largest);
    check_.store(b_.check);
    peak.store(b_.peak);
    kink.to_film.store(b_.to_film);
    kink.to_cavity.store(b_.to_cavity);
  }

  LaneBlock& b_;
  Real h_m_, inverse_content_scale_;
  Motion<Real, kFilmContent, kTerms> motion_;
  Visitor load_, slope_;  ///< W_h + W_a, and the slope of W_a in h_m, as far as visited
  Real check_;
};

}  // namespace ringfilm::film
