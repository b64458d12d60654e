#include "ringfilm/life/wear/worn_face.hpp"

#include <algorithm>

#include "ringfilm/cycle/integration/cycle_film.hpp"
#include "ringfilm/cycle/setup/setup.hpp"

namespace ringfilm::life {

WornFace::WornFace(const cycle::Case& c) : unworn_(c.ring.face), grid_(cycle::face_grid(cycle::prepare(c))) {}

/// Height at the nodes (k even) and halfway between them, from the lowest point of the unworn face.
double WornFace::height_at(std::size_t k, const std::vector<double>& worn, double tilt) const {
  const std::size_t i = k / 2;
  const bool is_node = k % 2 == 0;
  const double height = is_node ? grid_.node_height[i] : grid_.face_height[i];
  const double lost = is_node ? worn[i] : 0.5 * (worn[i] + worn[i + 1]);
  const double x = is_node ? grid_.x[i] : 0.5 * (grid_.x[i] + grid_.x[i + 1]);
  return height + lost + tilt * (x - 0.5 * grid_.width);
}

cycle::RingFace WornFace::face(const std::vector<double>& worn, double tilt) const {
  const bool is_unworn = std::all_of(worn.begin(), worn.end(), [](double depth) { return depth == 0; });
  if (is_unworn && tilt == 0) return unworn_;
  cycle::RingFace face;
  face.form = cycle::FaceForm::kPoints;
  face.orientation = cycle::Orientation::kX0Chamber;
  for (std::size_t k = 0; k + 1 < 2 * n_nodes(); ++k) {
    const std::size_t i = k / 2;
    face.x.push_back(k % 2 == 0 ? grid_.x[i] : 0.5 * (grid_.x[i] + grid_.x[i + 1]));
    face.height.push_back(height_at(k, worn, tilt));
  }
  face.x.back() = grid_.width;  // which the sum of the cells may miss by its rounding
  return face;
}

std::vector<double> WornFace::heights(const std::vector<double>& worn, double tilt) const {
  std::vector<double> heights;
  double lowest = height_at(0, worn, tilt);
  for (std::size_t k = 0; k + 1 < 2 * n_nodes(); ++k) {
    const double height = height_at(k, worn, tilt);
    lowest = std::min(lowest, height);
    if (k % 2 == 0) heights.push_back(height);
  }
  const bool is_unworn = std::all_of(worn.begin(), worn.end(), [](double depth) { return depth == 0; });
  if (is_unworn && tilt == 0) lowest = 0;  // the true minimum may lie between the nodes
  for (double& height : heights) height -= lowest;
  return heights;
}

}  // namespace ringfilm::life
