#include "ringfilm/cycle/menisci/menisci_liner.hpp"

#include <algorithm>
#include <utility>

#include "ringfilm/case/conditions.hpp"
#include "ringfilm/cycle/integration/liner_oil.hpp"

namespace ringfilm::cycle {
namespace {

/// No step leaves more oil than this multiple of what its menisci leave at its begin and at its end: the next ones
/// follow [-].
constexpr double kMaxToExpected = 4;

}  // namespace

MenisciLiner::MenisciLiner(const Setup& setup, double place)
    : setup_(&setup),
      face_width_(setup.input.ring.face_width),
      length_(setup.engine.crank.stroke() + setup.input.ring.face_width),
      reach_(setup.input.supply.reach.value_or(0)),
      left_(-place),
      right_(place) {
  const double reach = std::clamp(reach_, 0.0, place);
  add_supply(reach, place, 1, left_, -1);
  add_supply(0, reach, kFirstAboveReach, left_, -1);
  const double beyond = std::clamp(reach_, place, length_);
  add_supply(place, beyond, kFirstAboveReach, right_, 1);
  add_supply(beyond, length_, 1, right_, 1);
}

/// Adds a share of what the oil ring leaves between two places, outwards. @param sign of the places of the side
void MenisciLiner::add_supply(double begin, double end, double share, LinerSide& side, double sign) const {
  const std::vector<StrokeValue>& film = setup_->input.supply.film;
  if (film.empty() || !(end > begin)) return;
  std::vector<double> places{begin};
  for (const StrokeValue& point : film) {
    if (point.distance > begin && point.distance < end) places.push_back(point.distance);
  }
  places.push_back(end);
  if (sign < 0) std::reverse(places.begin(), places.end());
  const auto oil = [&](double place) { return share * setup_->ring.oil.density * along_stroke(film, place); };
  for (std::size_t k = 1; k < places.size(); ++k) {
    side.add_beyond(sign * places[k - 1], sign * places[k], oil(places[k - 1]), oil(places[k]));
  }
}

void MenisciLiner::pass(const OilOfStep& step) {
  double left_over = owed_ + (film_mass_ - step.film_mass) + (bead_ - step.bead);
  struct Side {
    LinerSide* oil;
    double place;       ///< place of its meniscus at the end of the step
    double begin, end;  ///< mass per area that it leaves
    double length() const { return oil->end() - place; }
    double expected() const { return 0.5 * (begin + end) * length(); }
  };
  Side sides[] = {{&left_, -step.left_end, step.left_at_begin.left, step.left_at_end.left},
                  {&right_, step.right_end, step.left_at_begin.right, step.left_at_end.right}};
  double expected = 0, length = 0;
  for (const Side& side : sides) {
    if (side.length() < 0) {
      left_over += side.oil->take_up(side.place);
    } else if (side.length() > 0) {
      expected += side.expected();
      length += side.length();
    }
  }
  film_mass_ = step.film_mass;
  bead_ = step.bead;
  owed_ = left_over;
  if (!(length > 0)) return;
  double laid = std::max(left_over, 0.0);
  if (step.bead_bears_error && expected > 0) {
    bead_ += left_over - expected;
    left_over = laid = expected;
  } else if (expected > 0) {
    laid = std::min(laid, kMaxToExpected * expected);
  }
  owed_ = left_over - laid;
  for (const Side& side : sides) {
    if (!(side.length() > 0)) continue;
    const double share = expected > 0 ? side.expected() / expected : side.length() / length;
    side.oil->lay(side.place, share * laid, side.end, side.begin);
  }
}

void MenisciLiner::drain(bool left, double from, const std::vector<LinerSide::Point>& drained) {
  LinerSide& side = left ? left_ : right_;
  const double outer = left ? -from : from;
  std::vector<LinerSide::Point> points;
  for (const LinerSide::Point& point : drained) {
    if (const double place = outer - point.place; place > side.end()) points.push_back({place, point.oil});
  }
  std::reverse(points.begin(), points.end());
  if (points.size() > 1) side.shape(points);
}

void MenisciLiner::scrape(bool up) {
  (up ? account_.scraped_up : account_.scraped_down) += std::max(bead_, 0.0);
  // What the bead owes to the liner is taken from what the next step leaves.
  owed_ += std::min(bead_, 0.0);
  bead_ = 0;
}

void MenisciLiner::replenish() {
  const double begin = std::max({reach_, right_.end(), face_width_});
  if (!(begin < length_)) return;
  const double before = right_.mass();
  right_.cut_beyond(begin);
  add_supply(begin, length_, 1, right_, 1);
  account_.replenished += right_.mass() - before;
}

double MenisciLiner::all() const {
  return left_.mass() + right_.mass() + film_mass_ + bead_ + owed_ + account_.scraped_up + account_.scraped_down -
         account_.replenished;
}

std::vector<double> MenisciLiner::in_cells(std::size_t n) const {
  const double cell = length_ / static_cast<double>(n);
  std::vector<double> oil(n, 0.0);
  left_.add_to_cells(cell, -1, oil);
  right_.add_to_cells(cell, 1, oil);
  for (double& one : oil) one /= cell;
  return oil;
}

void MenisciLiner::replace(const std::vector<double>& cells) {
  const double cell = length_ / static_cast<double>(cells.size());
  const auto fill = [&](double sign, double end) {
    LinerSide side(end);
    const auto n = static_cast<int>(cells.size());
    for (int k = 0; k < n; ++k) {
      const int c = sign > 0 ? k : n - 1 - k;
      const double near = std::max(sign * (sign > 0 ? c : c + 1) * cell, end),
                   far = sign * (sign > 0 ? c + 1 : c) * cell;
      side.add_beyond(near, far, cells[c], cells[c]);
    }
    return side;
  };
  left_ = fill(-1, left_.end());
  right_ = fill(1, right_.end());
}

}  // namespace ringfilm::cycle
