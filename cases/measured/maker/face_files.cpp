#include <fmt/format.h>

#include <cmath>
#include <cstdint>

#include "measured_chain.hpp"
#include "measured_files.hpp"
#include "ringfilm/surface/synthetic/random_numbers.hpp"

namespace ringfilm::measured_files {
namespace {

constexpr int kPoints = 1401;
constexpr double kStep_mm = 0.001;
constexpr double kNoise_um = 0.01;
constexpr double kChamfer_um_per_mm = 300;  // beyond the face, on top of the slope at its edge
constexpr std::uint64_t kFirstSeed = 20150;

/// Height and slope of the polynomial [um, um/mm].
struct Gap {
  double height = 0, slope = 0;
};

Gap gap_at(const std::vector<double>& coefficients, double x_mm) {
  Gap gap;
  for (const double c : coefficients) {
    gap.slope = gap.slope * x_mm + gap.height;
    gap.height = gap.height * x_mm + c;
  }
  return gap;
}

/// Inside the face the polynomial, beyond it a chamfer.
double gap_um(const std::vector<double>& coefficients, double x_mm, double width_mm) {
  const double inside = std::min(std::max(x_mm, 0.0), width_mm);
  const Gap edge = gap_at(coefficients, inside);
  const double beyond = x_mm - inside;
  return edge.height + edge.slope * beyond + kChamfer_um_per_mm * std::abs(beyond);
}

GeneratedFile face_file(const TargetRing& ring, std::uint64_t seed) {
  const surface::FaceRule rule = app::chain::face_rule();
  const double start_mm = 1e3 * *rule.start_m, width_mm = 1e3 * rule.width_m;
  surface::RandomNumbers random(seed);
  std::string text = fmt::format(
      "# SYNTHETIC stylus trace over the face of the {} ring, made by ringfilm (cases/measured), seed {}\n"
      "x [mm],z [um]\n",
      ring.name, seed);
  for (int i = 0; i < kPoints; ++i) {
    const double x_mm = kStep_mm * i;
    const double tilt_um = 1e3 * rule.tilt * x_mm;
    const double gap = gap_um(ring.face_mm_um, x_mm - start_mm, width_mm) + tilt_um + kNoise_um * random.normal();
    text += fmt::format("{:.3f},{:.4f}\n", x_mm, -gap);
  }
  return {"face_" + ring.name + ".csv", text};
}

}  // namespace

std::vector<GeneratedFile> face_files(const std::vector<TargetRing>& rings) {
  std::vector<GeneratedFile> files;
  std::uint64_t seed = kFirstSeed;
  for (const TargetRing& ring : rings) files.push_back(face_file(ring, ++seed));
  return files;
}

}  // namespace ringfilm::measured_files
