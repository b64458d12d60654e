#include "fuzz_target.hpp"
#include "input_file.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/io/data/face_file.hpp"
#include "ringfilm/models/ring.hpp"

/// The points of a ring face as CSV; what passes becomes a face as wide as its points.
RINGFILM_FUZZ_TARGET(face) {
  using namespace ringfilm;
  static const io::Units units;
  const std::string path = fuzz::input_file(data, size, "face.csv");
  try {
    const io::FaceFile file = io::read_face({path, "face.csv"}, units);
    const double width = file.x.back();
    if (file.x.front() <= 0 && width > 0) models::RingFace::points(file.x, file.height, width).minimum();
  } catch (const InputError& error) {
    describe(error.faults());
  }
  return 0;
}
