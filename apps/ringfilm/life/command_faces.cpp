#include <fmt/format.h>

#include <iostream>

#include "life/command_life.hpp"
#include "ringfilm/base/display.hpp"
#include "ringfilm/io/life/face_comparison.hpp"

namespace ringfilm::app {
namespace {

std::string row(const io::FacePair& pair, std::size_t k) {
  const life::WearBound &level = pair.level[k], &tilted = pair.tilted[k], &turned = pair.turned[k];
  return fmt::format("{:>10.3f} {:>8.2f} {:>8.2f} {:>10.2f} {:>8.2f} {:>7.1f} {:>10.2f} {:>8.2f} {:>7.1f}\n",
                     number_in(level.margin, kMillimetre), number_in(level.depth_at_middle, kMicrometre),
                     number_in(level.area, kWornArea), number_in(tilted.depth_at_middle, kMicrometre),
                     number_in(tilted.area, kWornArea), number_in(tilted.tilt, kArcMinute),
                     number_in(turned.depth_at_middle, kMicrometre), number_in(turned.area, kWornArea),
                     number_in(turned.tilt, kArcMinute));
}

std::string table(const io::FaceComparison& comparison) {
  std::string text = "least wear between faces if material only disappears; depths at the middle [um], areas [um mm]\n";
  for (const io::FacePair& pair : comparison.pairs) {
    text += fmt::format("\n{} to {}\n{:>10} {:>17} {:>27} {:>27}\n", pair.earlier, pair.later, "margin mm",
                        "level: um, um mm", "tilt free: um, um mm, '", "turned: um, um mm, '");
    for (std::size_t k = 0; k < pair.level.size(); ++k) text += row(pair, k);
  }
  text += "\n";
  for (std::size_t i = 0; i < comparison.faces.size(); ++i) {
    for (const life::ConcaveStretch& stretch : comparison.concave[i]) {
      text += fmt::format(
          "{}: from {:.3f} to {:.3f} mm the face is {:.2f} um above its convex hull: no straight liner "
          "touches it there, and wear by it cannot make that shape\n",
          comparison.faces[i].name, number_in(stretch.from, kMillimetre), number_in(stretch.to, kMillimetre),
          number_in(stretch.height, kMicrometre));
    }
  }
  return text +
         "these are lower bounds: more wear is always possible, and what the edges lost must be added to the middle\n";
}

}  // namespace

void compare_faces(const FacesOptions& options) {
  const io::FaceComparison comparison = io::read_face_comparison(options.case_paths);
  std::cout << (options.summary == SummaryForm::kJson ? io::face_comparison_json(comparison) : table(comparison));
}

}  // namespace ringfilm::app
