#include "ringfilm/models/section/twisting_ring.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>

namespace ringfilm::models {
namespace {

using std::numbers::pi;

/// Corners that lie no farther back than this share of the thickness are the foremost ones [-].
constexpr double kForemost = 1e-6;
/// A flank is the longest side that is inclined by less than this against the radial direction: cosine of 30 degrees.
constexpr double kFlat = 0.866;

struct Normal {
  double axial, radial;  ///< outwards, of unit length; axial towards the crankcase
};

/// @param from @param to a side of a polygon whose area is positive in (axial, radial)
Normal normal_of(const SectionPoint& from, const SectionPoint& to) {
  const double length = std::hypot(to.axial - from.axial, to.radial - from.radial);
  return {(to.radial - from.radial) / length, -(to.axial - from.axial) / length};
}

double length_of(const SectionPoint& from, const SectionPoint& to) {
  return std::hypot(to.axial - from.axial, to.radial - from.radial);
}

SectionPoint place_on_side(const SectionPoint& from, const SectionPoint& to, double share) {
  return {from.axial + share * (to.axial - from.axial), from.radial + share * (to.radial - from.radial)};
}

/// Number of the longest side that looks that way (-1: to the chamber); where none is flat, the one that is flattest.
std::size_t flank_side(const SectionPolygon& corners, double way) {
  std::size_t best = 0;
  double best_rank = -2;
  double longest = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    longest = std::max(longest, length_of(corners[i], corners[(i + 1) % corners.size()]));
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const SectionPoint &from = corners[i], &to = corners[(i + 1) % corners.size()];
    const double towards = way * normal_of(from, to).axial;
    const double rank = towards >= kFlat ? 1 + length_of(from, to) / longest : towards - 1;
    if (rank > best_rank) best = i;
    best_rank = std::max(best_rank, rank);
  }
  return best;
}

}  // namespace

TwistingRing::TwistingRing(const TwistingRingSize& size)
    : area_(section_area(size.section)), bore_radius_(size.bore / 2), face_width_(size.face_width) {
  const SectionPolygon corners = normalized(size.section);
  const SectionExtent extent = section_extent(corners);
  foremost_ = extent.low.radial;
  land_ = foremost_ + size.land_clearance;
  r_c_ = bore_radius_ - (area_.centroid.radial - foremost_);
  friction_arm_ = bore_radius_ - r_c_;
  stiffness_ = 2 * pi * size.youngs_modulus * area_.axial / r_c_;
  const double determinant = area_.axial * area_.radial - area_.product * area_.product;
  assembly_twist_ = size.tangential_force * r_c_ * r_c_ * area_.product / (size.youngs_modulus * determinant);
  assembly_couple_ = size.tangential_force * area_.product / area_.radial;
  side_clearance_ = size.side_clearance;
  double lowest_foremost = extent.low.axial;
  for (const SectionPoint& corner : corners) {
    if (corner.radial - foremost_ <= kForemost * extent.thickness()) {
      lowest_foremost = std::max(lowest_foremost, corner.axial);
    }
  }
  face_begin_ = std::clamp(lowest_foremost - face_width_, extent.low.axial,
                           std::max(extent.low.axial, extent.high.axial - face_width_));
  centroid_below_edge_ = area_.centroid.axial - face_begin_;
  lay_sides(corners, face_width_);
}

void TwistingRing::lay_sides(const SectionPolygon& corners, double face_width) {
  const std::size_t n = corners.size();
  const std::size_t upper = flank_side(corners, -1), lower = flank_side(corners, 1);
  const auto flank = [&](std::size_t side) {
    const auto [outer, inner] = std::minmax(corners[side].radial, corners[(side + 1) % n].radial);
    return Flank{std::max(outer, land_), std::max(inner, land_)};
  };
  upper_ = flank(upper);
  lower_ = flank(lower);
  // The polygon goes from the chamber to the crankcase along the face, and back along the groove.
  const auto add = [&](const SectionPoint& from, const SectionPoint& to, Reached reached) {
    if (!(from == to)) sides_.push_back({from, to, reached});
  };
  const double begin = face_begin_, end = face_begin_ + face_width;
  for (std::size_t i = 0; i < n; ++i) {
    const SectionPoint &from = corners[i], &to = corners[(i + 1) % n];
    if (i == upper || i == lower) {
      add(from, to, i == upper ? Reached::kUpperFlank : Reached::kLowerFlank);
      continue;
    }
    const bool is_behind = (i + n - lower) % n < (upper + n - lower) % n;  // after the lower flank, before the upper
    if (is_behind) {
      add(from, to, Reached::kGroove);
      continue;
    }
    // Along the face it is cut at both ends of the running face. What looks away from the bore is not part of it.
    std::vector<double> cuts{0, 1};
    for (const double at : {begin, end}) {
      if (from.axial == to.axial) continue;  // parallel to the flanks
      const double share = (at - from.axial) / (to.axial - from.axial);
      if (share > 0 && share < 1) cuts.push_back(share);
    }
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
      const SectionPoint p = place_on_side(from, to, cuts[k]), q = place_on_side(from, to, cuts[k + 1]);
      const double middle = 0.5 * (p.axial + q.axial);
      const bool runs = middle > begin && middle < end && normal_of(from, to).radial < 0;
      add(p, q, runs ? Reached::kFace : (middle < 0.5 * (begin + end) ? Reached::kAbove : Reached::kBelow));
    }
  }
}

double TwistingRing::pressure(const Side& side, double radial, const PressuresAroundRing& pressures) const {
  const auto channel = [&](const Flank& flank, double at_edge) {
    if (radial <= flank.outer || flank.inner <= flank.outer) return at_edge;
    const double share = std::min((radial - flank.outer) / (flank.inner - flank.outer), 1.0);
    return std::sqrt(std::max((1 - share) * at_edge * at_edge + share * pressures.groove * pressures.groove, 0.0));
  };
  switch (side.reached) {
    case Reached::kAbove:
      return pressures.above;
    case Reached::kBelow:
      return pressures.below;
    case Reached::kGroove:
      return pressures.groove;
    case Reached::kUpperFlank:
      return channel(upper_, pressures.above);
    case Reached::kLowerFlank:
      return channel(lower_, pressures.below);
    case Reached::kFace:
      break;
  }
  return 0;
}

ForceOnRing TwistingRing::gas(const PressuresAroundRing& pressures) const {
  using Gauss = boost::math::quadrature::gauss<double, 15>;
  ForceOnRing sum;
  for (const Side& side : sides_) {
    if (side.reached == Reached::kFace) continue;
    const Normal normal = normal_of(side.from, side.to);
    const double length = length_of(side.from, side.to);
    // Cut where the channel begins, so that what is integrated is smooth.
    std::vector<double> cuts{0, 1};
    if (side.reached == Reached::kUpperFlank || side.reached == Reached::kLowerFlank) {
      const Flank& flank = side.reached == Reached::kUpperFlank ? upper_ : lower_;
      const double share = (flank.outer - side.from.radial) / (side.to.radial - side.from.radial);
      if (std::isfinite(share) && share > 0 && share < 1) cuts = {0, share, 1};
    }
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
      const auto place = [&](double share) { return place_on_side(side.from, side.to, share); };
      const auto force = [&](double share) {
        const SectionPoint at = place(share);
        return pressure(side, at.radial, pressures) * 2 * pi * (bore_radius_ - (at.radial - foremost_));
      };
      // y outwards and z towards the chamber, from the centroid; the gas pushes against the normal.
      const auto moment = [&](double share) {
        const SectionPoint at = place(share);
        const double y = area_.centroid.radial - at.radial, z = area_.centroid.axial - at.axial;
        return force(share) * (y * normal.axial - z * normal.radial);
      };
      sum.axial += length * normal.axial * Gauss::integrate(force, cuts[k], cuts[k + 1]);
      sum.moment += length * Gauss::integrate(moment, cuts[k], cuts[k + 1]);
    }
  }
  return sum;
}

double TwistingRing::halved_face(const PressuresAroundRing& pressures) const {
  const double half = face_width_ / 2, upper = centroid_below_edge_ - half / 2, lower = upper - half;
  return 2 * pi * bore_radius_ * half * (pressures.above * upper + pressures.below * lower);
}

HeldTwist TwistingRing::held(const ForceOnRing& force) const {
  // Seated on the lower flank where it is pressed towards the crankcase; else on the upper one.
  const double seating = -force.axial, flat = force.moment + stiffness_ * assembly_twist_;
  const Flank& flank = seating >= 0 ? lower_ : upper_;
  const auto radius = [&](double radial) { return bore_radius_ - (radial - foremost_); };
  const double outer = radius(flank.outer), inner = radius(flank.inner);
  HeldTwist twist;
  double excess = flat;
  if (seating != 0) {
    const double wanted = r_c_ - flat / seating, at = std::clamp(wanted, inner, outer);
    twist.reaction_radius = wanted;
    if (at == wanted) return twist;
    excess = flat + seating * (at - r_c_);
  }
  twist.angle = excess / stiffness_;
  if (outer > inner) {
    const double most = side_clearance_ / (outer - inner);
    twist.angle = std::clamp(twist.angle, -most, most);
  }
  return twist;
}

}  // namespace ringfilm::models
