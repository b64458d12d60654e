#pragma once
#include "ringfilm/base/pack.hpp"

/// The discrete balance of mass of a film (eq-discrete-balance): flux through a face, what a node stores, the step
/// across the kink between film and cavity, shear and heat of a cell. Written once, over the type of number: a double,
/// or a pack of films, nodes or strips. Plain values, so that what is compiled for one machine holds no code that
/// another shares.
namespace ringfilm::film {

/// How far beyond the kink a node is put, and below which a change of sides does not count; relative to the scale of
/// its side: of pressure in the film, of the film content in the cavity.
inline constexpr double kBeyondKink = 1e-10;

/// A node with no larger deficit was left just beyond the kink: it is full, at p_c.
inline constexpr double kCavityThreshold = 10 * kBeyondKink;

inline constexpr double kMaxPressureRise = 20;  // scales in one step: the viscosity is exponential in it

/// For what is written over the type of number, as of a pack.
RINGFILM_INLINE double min(double a, double b) { return a < b ? a : b; }
RINGFILM_INLINE double max(double a, double b) { return a > b ? a : b; }

/// The gap through which the wall carries the oil of a node upstream of a face, theta of the node times that gap being
/// what passes, and the slope of this product in theta [m].
template <class Real>
struct CarriedGap {
  Real gap, slope;
};

/// Largest difference between the gap of a node and that of a face, as a share of the gap of the face. With a third
/// more, a node that fills would pass on less.
inline constexpr double kMaxExcess = 0.25;

/// A cavity moves on with what its node holds, theta h there (eq-carried-gap): by the gap of the face it would hold
/// more or less than passes, by half a cell of the slope of the face. A full node fills the face.
template <class Real>
RINGFILM_INLINE CarriedGap<Real> carried_gap(Real theta, Real at_node, Real at_face) {
  const Real most = Real(kMaxExcess) * at_face, excess = max(min(at_node - at_face, most), -most);
  const Real filled = max(Real(0), theta);  // less than nothing, in the iteration, moves on as it is
  const Real cube = filled * filled * filled;
  return {at_face + excess * (Real(1) - cube), at_face + excess * (Real(1) - Real(4) * cube)};
}

/// Mass flow of the moving wall through a face, per sum of the densities of its two nodes [m2/s].
template <class Real>
RINGFILM_INLINE Real entrainment(Real quarter_U, Real content_upstream, Real h) {
  return quarter_U * content_upstream * h;
}

/// Mass flow through a face per sum of K of its two nodes and their difference of pressure, h^3/(24 dx) [m2].
/// @param cube mean of h^3 over the face [m3]  @param spacing distance of the nodes [m]
RINGFILM_INLINE double conductance(double cube, double spacing) { return cube / (24 * spacing); }

/// Mass flux through a face by pressure, in the direction of rising node numbers [kg/(m s)]. @param K sum over its two
/// nodes  @param dp pressure of the later node less that of the earlier one
template <class Real>
RINGFILM_INLINE Real pressure_flux(Real conductance, Real K, Real dp) {
  return -conductance * (K * dp);
}

/// Mass flux through a face by motion and pressure. @param rho sum over the two nodes
template <class Real>
RINGFILM_INLINE Real face_flux(Real entrainment, Real rho, Real conductance, Real K, Real dp) {
  return entrainment * rho - conductance * (K * dp);
}

/// A node, and its oil at its pressure.
template <class Real>
struct Node {
  Real p, theta, rho, drho, K, dK;  ///< pressure from any zero [Pa]; K = rho/eta; theta: the share that flows
  typename Real::Mask is_film;
  Real filled;   ///< share of the gap that holds oil: theta, but of a film that lies on the wall (carried_share)
  Real gain{1};  ///< slope of theta in `filled`
};

/// How much of a gap flows, by the share that holds oil. In a cavity both walls carry the oil, at U/2 in the mean. A
/// film next to the gas of an edge lies on the moving wall, at U: it counts twice, until it is half of the gap
/// (eq-film-on-wall).
inline constexpr double kOnWall = 2, kBetweenWalls = 1;
template <class Real>
RINGFILM_INLINE Real carried_share(Real filled, Real carry) {
  return min(Real(1), carry * filled);
}

/// Flux through a face, and its slopes in z of its two nodes and in h.
template <class Real>
struct Flux {
  Real value, by_left, by_right, by_h;
};

/// What a film has beyond full edges of oil, smooth walls and a Newtonian oil.
enum class Terms {
  kPlain,  ///< nothing: the lowest pressure of all nodes is p_c, and pressure drives oil out of full nodes alone
  kAll,    ///< each node has its lowest pressure (eq-pressure-bound), and pressure drives out of a node the oil that it
           ///< has; inlets may be short of oil (limit_inlet); flow factors
};

/// Four times the mass per area of an inlet that is not short of oil [kg/m2].
inline constexpr double kUnlimited = 1e300;

/// The walls as the faces see them. @tparam kFilmContent the cavity carries theta of its upstream node
template <class Real, bool kFilmContent, Terms kTerms>
struct Motion {
  Real quarter_U, content_from_left, content_from_right;  ///< U/4; slopes in z of what a cavity on this side carries
  Real inverse_content_scale;

  RINGFILM_INLINE Motion(Real quarter_U_, Real inverse_content_scale_)
      : quarter_U(quarter_U_), inverse_content_scale(inverse_content_scale_) {
    const Real to_right = select(quarter_U >= Real(0), Real(1), Real(0));
    content_from_left = to_right * quarter_U * inverse_content_scale;
    content_from_right = (Real(1) - to_right) * quarter_U * inverse_content_scale;
  }
  /// Value at the upstream end of a face, given those at both ends.
  RINGFILM_INLINE Real upstream(Real left, Real right) const { return select(quarter_U >= Real(0), left, right); }
  RINGFILM_INLINE Real content(const Node<Real>& left, const Node<Real>& right) const {
    return upstream(left.theta, right.theta);
  }
  RINGFILM_INLINE Real upwind(const Node<Real>& left, const Node<Real>& right) const {
    if constexpr (kFilmContent) {
      return quarter_U * content(left, right);
    } else {
      return quarter_U;
    }
  }
};

/// @param h mean height of the oil that the wall carries through the face  @param upstream gap at the node upstream,
/// with what `h` has beyond the gap of the face  @param conductance of the mean of h^3
/// @param third a third of the slope of `conductance` in h
template <class Real, bool kFilmContent, Terms kTerms>
RINGFILM_INLINE Flux<Real> flux(const Motion<Real, kFilmContent, kTerms>& motion, Real h,
                                [[maybe_unused]] Real upstream, Real conductance, Real third, const Node<Real>& left,
                                const Node<Real>& right) {
  const Real K = left.K + right.K;
  const Real rho = left.rho + right.rho;
  const Real dp = right.p - left.p;
  const Real upwind = motion.upwind(left, right);
  CarriedGap<Real> carried{h, h};
  if constexpr (kFilmContent) carried = carried_gap(motion.content(left, right), upstream, h);
  const Real couette = upwind * carried.gap;
  [[maybe_unused]] Real drained_left(0), drained_right(0);
  if constexpr (kFilmContent && kTerms == Terms::kAll) {
    const auto to_left = dp > Real(0);
    const Real theta = select(to_left, right.theta, left.theta);
    const Real drained = pressure_flux(conductance, K, dp) * motion.inverse_content_scale;
    drained_left = select(to_left, Real(0), drained * left.gain);
    drained_right = select(to_left, drained * right.gain, Real(0));
    conductance = theta * conductance;
    third = theta * third;
  }
  Flux<Real> flux;
  flux.value = face_flux(couette, rho, conductance, K, dp);
  const Real film_left = couette * left.drho + conductance * (K - left.dK * dp);
  const Real film_right = couette * right.drho - conductance * (K + right.dK * dp);
  if constexpr (kFilmContent) {
    const Real stream = carried.slope * rho;
    if constexpr (kTerms == Terms::kAll) {
      flux.by_left = select(left.is_film, film_left, motion.content_from_left * left.gain * stream + drained_left);
      flux.by_right =
          select(right.is_film, film_right, motion.content_from_right * right.gain * stream + drained_right);
    } else {
      flux.by_left = select(left.is_film, film_left, motion.content_from_left * stream);
      flux.by_right = select(right.is_film, film_right, motion.content_from_right * stream);
    }
  } else {
    flux.by_left = select(left.is_film, film_left, Real(0));
    flux.by_right = select(right.is_film, film_right, Real(0));
  }
  flux.by_h = upwind * rho - Real(3) * third * (K * dp);
  return flux;
}

/// Through the face at an edge no more comes in than lies on the wall, eq-inlet-supply. In time what the wall carries
/// is limited first: where the pressure beside the edge is not below that of its gas, this has no kink in that
/// pressure.
/// @param flux that of a full gap at the edge  @param inward 1 at the left edge, -1 at the right one
/// @param supply four times the mass per area on the wall, or kUnlimited [kg/m2]
/// @param is_steady mask of the films without storage
template <class Real, class Mask>
RINGFILM_INLINE void limit_inlet(Real quarter_U, Real h, Real inward, Real supply, Mask is_steady,
                                 const Node<Real>& left, const Node<Real>& right, Flux<Real>& flux) {
  const auto is_limited = supply < Real(kUnlimited);
  if (!Real::any(is_limited)) return;
  const Real rho = left.rho + right.rho, arriving = max(inward * quarter_U, Real(0));
  const Real surplus = select(is_steady, Real(0), select(arriving > Real(0), h * rho - supply, Real(0)));
  const auto of_wall = surplus > Real(0);
  if (Real::any(of_wall)) {
    const auto take = [&](Real& from, Real what)
                          RINGFILM_INLINE_BODY { from -= select(of_wall, quarter_U * what, Real(0)); };
    take(flux.value, surplus);
    take(flux.by_left, select(left.is_film, h * left.drho, Real(0)));
    take(flux.by_right, select(right.is_film, h * right.drho, Real(0)));
    take(flux.by_h, rho);
  }
  const Real limit = arriving * supply;
  const Real pressed = select(is_steady, Real(1), inward * (left.p - right.p));  // by the gas: rounding is not
  const auto whole = Real::both(Real::both(inward * flux.value - limit > Real(0), pressed > Real(0)), is_limited);
  if (!Real::any(whole)) return;
  flux = {select(whole, inward * limit, flux.value), select(whole, Real(0), flux.by_left),
          select(whole, Real(0), flux.by_right), select(whole, Real(0), flux.by_h)};
}

/// What the moving wall carries through the narrowest place while gas blows through there against the motion.
template <class Real>
struct PassedGap {
  Real gap;                         ///< height of a full gap that would carry as much [m]
  Real by_held, by_full, by_slope;  ///< slopes in the arguments
};

/// Solves eq-broken-film-grid. @param full gap of what the wall would carry without the gas [m]
/// @param held pressure of the gas over that of the film at the node before the narrowest place, above 0 [Pa]
/// @param slope by which the pressure of the film rises up to that place per gap that is held back [Pa/m]
/// @param reach as of Throat, above 0
template <class Real>
RINGFILM_INLINE PassedGap<Real> passed_gap(Real full, Real held, Real slope, Real reach) {
  constexpr int kMaxIterations = 60;
  constexpr double kRounding = 1e-14;
  // Of u, the root of what the gas has over the film at the place itself. From above the iteration falls to the root.
  const Real linear = slope * full - held;
  Real u = sqrt(held);
  for (int k = 0; k < kMaxIterations; ++k) {
    const Real next = u - ((u * u + linear) * u - slope * reach) / (Real(3) * u * u + linear);
    const auto moves = next < u * Real(1 - kRounding);
    if (!Real::any(moves)) break;
    u = select(moves, next, u);
  }
  const Real steepness = Real(1) / (Real(3) * u * u + linear), by_u = -reach / (u * u);
  const auto is_full = reach * reach >= held * full * full;
  return {select(is_full, full, reach / u), select(is_full, Real(0), by_u * u * steepness),
          select(is_full, Real(1), -by_u * slope * u * steepness),
          select(is_full, Real(0), by_u * (reach - full * u) * steepness)};
}

/// Share by which the node behind the narrowest place is so full that its oil presses against the film there, and not
/// gas: what lies on the wall alone is less than half of the gap. @param filled share of the gap that holds oil
template <class Real>
RINGFILM_INLINE Real pressing_share(Real filled, Real least) {
  return max(Real(0), min(Real(1), (filled - least) / (Real(1) - least)));
}
/// Where it begins, by `carry` of carried_share().
inline constexpr double kPressingOnWall = 0.5, kPressingBetweenWalls = 0.9;

/// Share of the gap up to which oil hangs at rest.
inline constexpr double kHanging = 0.9;

/// Where oil hangs on the face behind the film, the wall takes along what a meniscus leaves on it until the gap is all
/// but full (eq-outlet). @param left twice the share of the gap that a meniscus leaves, up to 1
/// @returns the most that carried_share() may be
template <class Real>
RINGFILM_INLINE Real hanging_share(Real filled, Real left) {
  return left + (Real(1) - left) * pressing_share(filled, Real(kHanging));
}
template <class Real>
RINGFILM_INLINE void let_hang(Real left, Node<Real>& node) {
  const Real most = hanging_share(node.filled, left);
  const Real rise = select(node.filled > Real(kHanging), (Real(1) - left) * Real(1 / (1 - kHanging)), Real(0));
  node.gain = select(most < node.theta, rise, node.gain);
  node.theta = min(node.theta, most);
}

/// Through a face at which gas blows against the motion the film before it passes on what eq-broken-film lets through.
/// @param flux that of a film, at a face whose oil the pressure drives  @param held mask of such faces
/// @param place,pressure,reach of Throat  @param behind share of the gap behind that holds oil, 0 at an edge, and the
/// least that presses
template <class Real, class Mask, bool kFilmContent, Terms kTerms>
RINGFILM_INLINE void hold_back(const Motion<Real, kFilmContent, kTerms>& motion, Mask at_throat, Real pressure,
                               Real reach, Real place, Real behind, Real least, Real h, Real upstream, Real conductance,
                               Real third, const Node<Real>& left, const Node<Real>& right, Flux<Real>& flux) {
  const Real held = pressure - motion.upstream(left.p, right.p);
  const auto is_held = Real::both(at_throat, held > Real(0));
  if (!Real::any(is_held)) return;
  const Real rho = left.rho + right.rho, K = left.K + right.K;
  const Real content = motion.content(left, right);
  const CarriedGap<Real> carried = carried_gap(content, upstream, h);
  const auto where = [&](Real value, double else_) RINGFILM_INLINE_BODY { return select(is_held, value, Real(else_)); };
  const Real slope = where(place * abs(motion.quarter_U) * rho, 0) / where(conductance * K, 1);
  const PassedGap<Real> passed = passed_gap(where(content * carried.gap, 0), where(held, 1), slope, where(reach, 1));
  const Real full = pressing_share(behind, least), free = Real(1) - full;
  const auto is_between = Real::both(full > Real(0), free > Real(0));
  const Real by_full = select(is_between, motion.inverse_content_scale / (Real(1) - least), Real(0));

  const Real rate = motion.quarter_U * rho, value = rate * passed.gap;
  const Real drho = motion.upstream(left.drho, right.drho), dK = motion.upstream(left.dK, right.dK);
  const Real by_pressure = motion.quarter_U * (passed.gap * drho) +
                           rate * (passed.by_slope * slope * (drho / rho - dK / K) - passed.by_held);
  const Real by_content =
      rate * passed.by_full * carried.slope * motion.inverse_content_scale * motion.upstream(left.gain, right.gain);
  const Real by_before =
      motion.upstream(select(left.is_film, by_pressure, by_content), select(right.is_film, by_pressure, by_content));
  const Real by_behind = by_full * (flux.value - value);
  const Real by_h =
      rate * (passed.by_full * content - Real(3) * passed.by_slope * slope * third / where(conductance, 1));
  const auto mixed = [&](Real held_back, Real of_film)
                         RINGFILM_INLINE_BODY { return select(is_held, free * held_back + full * of_film, of_film); };
  const Real none(0);
  const Real left_before = motion.upstream(by_before, none), right_before = motion.upstream(none, by_before);
  const Real left_behind = select(is_held, motion.upstream(none, by_behind), none),
             right_behind = select(is_held, motion.upstream(by_behind, none), none);
  flux = {mixed(value, flux.value), mixed(left_before, flux.by_left) + left_behind,
          mixed(right_before, flux.by_right) + right_behind, mixed(by_h, flux.by_h)};
}

/// Where no wall moves along: the direction around the ring.
template <class Real>
RINGFILM_INLINE Flux<Real> cross_flux(Real conductance, Real third, const Node<Real>& low, const Node<Real>& high) {
  const Real K = low.K + high.K;
  const Real dp = high.p - low.p;
  Flux<Real> flux;
  flux.value = pressure_flux(conductance, K, dp);
  flux.by_left = select(low.is_film, conductance * (K - low.dK * dp), Real(0));
  flux.by_right = select(high.is_film, -conductance * (K + high.dK * dp), Real(0));
  flux.by_h = Real(-3) * third * (K * dp);
  return flux;
}

/// rho theta of a node.
template <bool kFilmContent, class Real>
RINGFILM_INLINE Real filled_density(const Node<Real>& node) {
  if constexpr (kFilmContent) {
    return node.rho * node.filled;
  } else {
    return node.rho;
  }
}

/// d(rho theta)/dz of a node whose cavity is filled in part.
template <class Real>
RINGFILM_INLINE Real filled_density_slope(const Node<Real>& node, Real inverse_content_scale) {
  return select(node.is_film, node.drho, node.rho * inverse_content_scale);
}

/// The weight of z in the cavity of Reynolds exit: the Poiseuille conductance of the node, so that z is a pressure.
/// @param conductances of both faces per cube of the gap  @param K at the cavitation pressure
template <class Real>
RINGFILM_INLINE Real multiplier_weight(Real conductances, Real gap, Real K) {
  return Real(2) * conductances * (gap * gap * gap) * K;
}

/// z of nodes moves by a step of Newton's method, but a node that would change sides stops just beyond the kink: there
/// the linearisation is that of the other side.
template <class Real>
struct KinkStep {
  Real scale, inverse_scale;                  ///< scale of pressures
  Real content_scale, inverse_content_scale;  ///< scale of z in a cavity
  Real to_film{0}, to_cavity{0};              ///< not 0 once a node has changed sides
  Real largest{0};                            ///< relative change so far; a NaN is not seen

  /// @returns z after the step
  template <bool kFilmContent>
  RINGFILM_INLINE Real take(Real before, Real step) {
    using Mask = typename Real::Mask;
    const Mask was_film = before > Real(0);
    Real after = before + select(was_film, min(step, Real(kMaxPressureRise) * scale), step);
    const Mask is_film = after > Real(0);
    if (Real::any(Real::differ(is_film, was_film))) {
      const Real beyond = Real(kBeyondKink) * scale;
      const Real hardly_empty = Real(kBeyondKink) * content_scale;
      const Mask entered = Real::only(is_film, was_film);
      const Mask left = Real::only(was_film, is_film);
      to_film = select(Real::both(entered, after > beyond), Real(1), to_film);
      to_cavity = select(Real::both(left, after < -hardly_empty), Real(1), to_cavity);
      after = select(entered, beyond, select(left, -hardly_empty, after));
    }
    Real change =
        abs(after - before) * (kFilmContent ? select(was_film, inverse_scale, inverse_content_scale) : inverse_scale);
    if constexpr (!kFilmContent) {
      const Mask above = -after > scale;
      if (Real::any(above)) change = select(above, abs(after - before) / max(-after, scale), change);
    }
    largest = max(largest, change);
    return after;
  }
};

/// Shear force of one cell by the motion of the walls, times 4/U [N s/m2]. @param h height of its face
/// @param rho_left,... of its nodes: viscosity is their mean  @param film content upstream [-]
template <class Real>
RINGFILM_INLINE Real cell_shear(Real spacing, Real film_content, Real h, Real rho_left, Real K_left, Real rho_right,
                                Real K_right) {
  // Twice the mean viscosity, times K of both: one division serves viscosity and gap.
  const Real eta = rho_left * K_right + rho_right * K_left;
  return spacing * (Real(2) * film_content) * eta / (h * K_left * K_right);
}

/// Oil of a full cell, by the means over its two nodes.
template <class Real>
struct CellOil {
  Real rho;          ///< [kg/m3]
  Real eta;          ///< viscosity under shear, thinned where the oil thins [Pa s]
  Real eta_of_flow;  ///< viscosity over mobility: the flow by pressure meets it [Pa s]
};

/// Heat made in a full cell, and what carries it away (eq-viscous-heating).
template <class Real>
struct CellHeating {
  Real dissipation;  ///< [W/m]
  Real conductance;  ///< int dx/h [-]
  Real flow;         ///< int of the mass flux, in the frame of the face [kg/s]
};

/// @param length filled length of the cell [m]  @param slope of the pressure in it [Pa/m]  @param h height of its face
/// @param stream height of the oil that the wall carries [m]  @param sliding stress by sliding between rough walls over
/// that between smooth ones, phi_f [-]  @param inverse_gap the same of the mean of 1/h, which conducts the heat [-]
template <class Real>
RINGFILM_INLINE CellHeating<Real> cell_heating(Real U, Real length, Real slope, Real h, Real stream, Real sliding,
                                               Real inverse_gap, const CellOil<Real>& oil) {
  const Real pressure_flow = h * h * h * slope / (Real(12) * oil.eta_of_flow);
  return {length * sliding / h * oil.eta * (U * U) + length * pressure_flow * slope, length * inverse_gap / h,
          length * oil.rho * (Real(0.5) * U * stream - pressure_flow)};
}

}  // namespace ringfilm::film
