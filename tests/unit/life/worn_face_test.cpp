#include "ringfilm/life/wear/worn_face.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "../cycle/styles_case.hpp"

namespace ringfilm::life {
namespace {

TEST(WornFace, CoversTheFaceWhateverItsWidth) {
  cycle::Case c = cycle::testing::styles_new_ring();
  c.ring.face.form = cycle::FaceForm::kParabola;
  c.ring.face.crown_height = 10e-6;
  for (int i = 0; i < 200; ++i) {
    c.ring.face_width = 1e-3 + 7e-6 * i;  // of many of them a sum of equal cells ends a rounding short
    const WornFace worn(c);
    const cycle::RingFace face = worn.face(std::vector<double>(worn.n_nodes(), 1e-7), 0);
    ASSERT_EQ(face.x.front(), 0.0) << c.ring.face_width;
    ASSERT_EQ(face.x.back(), c.ring.face_width);
  }
}

}  // namespace
}  // namespace ringfilm::life
