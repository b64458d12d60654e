#include <algorithm>
#include <cmath>

#include "ringfilm/film/menisci/menisci_film.hpp"

namespace ringfilm::film {
namespace {

/// A meniscus with all that its motion follows from.
struct MeniscusView {
  const Meniscus& meniscus;
  const MenisciInputs::Edge& edge;
  double outward;    ///< 1: the right one
  double flow;       ///< mass flux in +x [kg/(m s)]
  double h;          ///< [m]
  double on_liner;   ///< film beyond it, without its bead [m]
  double bead_film;  ///< film of the bead [m]
};

/// Change of the bead ahead of a leading meniscus, eq-bead-rate [kg/(m s)].
double bead_rate(const MenisciInputs& inputs, const MeniscusView& at, const MeniscusMotion& motion) {
  const double U = inputs.film.U;
  const double coming = -at.outward * U;  // speed at which the liner comes to the face
  switch (at.meniscus.place) {
    case MeniscusPlace::kAtEdge:
      return at.edge.density * coming * at.on_liner + at.outward * at.flow;
    case MeniscusPlace::kAtThroat:
      return at.edge.density * coming * (at.on_liner - motion.film);
    case MeniscusPlace::kFree:
      break;
  }
  const double meeting = coming + at.outward * motion.velocity;
  return meeting > 0 ? at.edge.density * meeting * (at.on_liner - motion.film) : 0;
}

/// At a throat the film that comes enters, and what leaves follows from the flow.
MeniscusMotion motion_of(const MenisciInputs& inputs, const MeniscusView& at, bool leads) {
  const double U = inputs.film.U, coming = at.on_liner + at.bead_film;
  if (at.meniscus.place != MeniscusPlace::kAtThroat) {
    return meniscus_motion(at.outward, at.flow / at.edge.density, U, at.h, coming);
  }
  if (leads) return {0, std::min(coming, kMaxEntering * at.h), false};
  const double wall = at.edge.density * U;
  return {0, wall != 0 ? at.flow / wall : 0, true};
}

}  // namespace

void MenisciFilm::set_motion(const MenisciInputs& inputs, const MenisciState& state, const OnLiner& on_liner,
                             MenisciBalance& balance) const {
  const double h_m = std::exp(state.ln_h_m);
  const bool left_leads = inputs.left_leads();
  const auto film_of_bead = [&](const MenisciInputs::Edge& edge, bool leads) {
    return leads && inputs.surplus == Surplus::kStays ? state.bead / (edge.density * kBeadLength) : 0;
  };
  const auto gap = [&](const Meniscus& meniscus) { return h_m + gap_height(*grid_, meniscus.x); };
  const MeniscusView left{state.left,
                          inputs.left,
                          -1,
                          balance.flow_left,
                          gap(state.left),
                          on_liner.left / inputs.left.density,
                          film_of_bead(inputs.left, left_leads)};
  const MeniscusView right{state.right,
                           inputs.right,
                           1,
                           balance.flow_right,
                           gap(state.right),
                           on_liner.right / inputs.right.density,
                           film_of_bead(inputs.right, !left_leads)};
  const MeniscusView& leading = left_leads ? left : right;
  if (state.is_dry()) {
    // What comes passes below the throat, and the bead with it, as far as the gas lets it.
    balance.arriving = leading.on_liner + leading.bead_film;
    const double film = std::min(balance.arriving, balance.passing);
    balance.left = balance.right = {0, film, false};
    (left_leads ? balance.right : balance.left).leaves = true;
    balance.bead_rate = std::abs(inputs.film.U) * leading.edge.density * (leading.on_liner - film);
    return;
  }
  balance.left = motion_of(inputs, left, left_leads);
  balance.right = motion_of(inputs, right, !left_leads);
  balance.bead_rate = bead_rate(inputs, leading, left_leads ? balance.left : balance.right);
}

FilmIntegrals MenisciFilm::integrals(const MenisciInputs& inputs, const MenisciState& state,
                                     const MenisciBalance& balance) const {
  const bool left_leads = inputs.left_leads();
  const double begin = left_leads || state.is_dry() ? state.left.x : balance.outlet;
  const double end = left_leads && !state.is_dry() ? balance.outlet : state.right.x;
  const double h_m = std::exp(state.ln_h_m), width = grid_->width, U = std::abs(inputs.film.U);
  FilmIntegrals sums;
  sums.hydrodynamic_load = inputs.left.pressure * state.left.x + inputs.right.pressure * (width - state.right.x);
  sums.peak_pressure = std::max(balance.peak_pressure, std::max(inputs.left.pressure, inputs.right.pressure));
  sums.wetted_begin = begin;
  sums.wetted_end = end;
  sums.flow_left = balance.flow_left;
  sums.flow_middle = sums.flow_right = balance.flow_right;
  sums.is_broken_through = begin == throat_.x || end == throat_.x;
  if (contact_->contact != nullptr) set_contact(*contact_, h_m, sums);
  // The fall of pressure along a throat that gas blows through acts on both walls alike.
  if (sums.is_broken_through) {
    const double rise = state.is_dry()       ? inputs.right.pressure - inputs.left.pressure
                        : begin == throat_.x ? -balance.excess
                                             : balance.excess;
    sums.shear_poiseuille = 0.5 * (h_m + throat_.height) * rise;
  }
  if (state.is_dry()) return sums;
  double flow = 0, squared = 0;
  const double entering = left_leads ? balance.flow_left : -balance.flow_right;
  const std::vector<double>& h = points_.h();
  for (std::size_t j = 0; j < points_.size(); ++j) {
    const double weight = points_.weight()[j];
    sums.hydrodynamic_load += weight * pressure_[j];
    const bool is_beyond = inputs.direction * (points_.x()[j] - balance.outlet) > 0;
    if (is_beyond) continue;  // oil that hangs there bears no shear
    const double eta = slope_[j] * rho_[j], m = entering - balance.lift_rate * mass_[j];
    const double rise =
        12 * eta * (0.5 * U * h[j] - m / rho_[j]) * inverse_cube_[j];  // slope of p in the direction of the liner
    const double of_sliding = U / h[j], of_pressure = h[j] * rise / (2 * std::sqrt(3.0) * eta);
    sums.shear_couette += inputs.direction * weight * eta * of_sliding;
    sums.shear_poiseuille += inputs.direction * weight * 0.5 * h[j] * rise;
    sums.heating.dissipation += weight * eta * h[j] * (of_sliding * of_sliding + of_pressure * of_pressure);
    sums.heating.conductance += weight / h[j];
    flow += weight * m;
    squared = std::max(squared, of_sliding * of_sliding + of_pressure * of_pressure);
  }
  sums.peak_shear_rate = std::sqrt(squared);
  sums.heating.mass_flow = std::abs(flow) / (end - begin);
  // Within the film the flow is what passed the left meniscus less what lifting stores up to there.
  const double middle = 0.5 * width;
  if (inputs.direction * (middle - balance.outlet) > 0 && middle > state.left.x && middle < state.right.x) {
    sums.flow_middle = 0.5 * inputs.film.U * inputs.trailing().density * (h_m + gap_height(*grid_, middle));
  } else if (middle > state.left.x && middle < state.right.x) {
    const double share = (middle - state.left.x) / (state.right.x - state.left.x);
    sums.flow_middle = balance.flow_left + share * (balance.flow_right - balance.flow_left);
  } else {
    sums.flow_middle = middle <= begin ? balance.flow_left : balance.flow_right;
  }
  return sums;
}

}  // namespace ringfilm::film
