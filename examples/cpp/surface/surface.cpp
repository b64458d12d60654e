// Roughness of a ring and its liner, the asperities of the pair, and the contact pressure between them.
//   surface RING LINER
#include <cstdio>
#include <exception>

#include "ringfilm/ringfilm.hpp"

namespace {

using namespace ringfilm;

surface::SurfaceMeasures measured(const char* path) {
  const io::Units units;
  surface::HeightMap map = instrument::read_surface_file(path, {}, units).map;
  surface::Preparation preparation;
  preparation.form = {surface::FormKind::tilt};
  preparation.short_cutoff_m = 1e-6;
  preparation.long_cutoff_m = 80e-6;
  surface::prepare(map, preparation);
  const surface::CoreRoughness core = surface::core_roughness(surface::material_ratio_curve(map));
  std::printf("%s: Sq %.3f um, Spk %.3f um, Svk %.3f um\n", path, 1e6 * surface::height_statistics(map).Sq_m,
              1e6 * core.Rpk_m, 1e6 * core.Rvk_m);
  return surface::surface_measures(map);
}

void compute(const char* ring_path, const char* liner_path) {
  const surface::SurfaceMeasures ring = measured(ring_path);
  const surface::SurfaceMeasures liner = measured(liner_path);
  const surface::AsperityParameters pair = surface::pair_parameters(ring, liner, surface::SigmaRule::ra);
  std::printf("asperity density %.3f um-2, radius %.2f um, composite roughness %.3f um\n", 1e-12 * pair.density_per_m2,
              1e6 * pair.beta_m, 1e6 * pair.sigma_m);

  const double E_prime = models::composite_modulus(203e9, 0.3, 92.3e9, 0.3);  // steel and grey iron, ASSUMED [Pa]
  const models::GreenwoodTripp law({pair.density_per_m2, pair.beta_m, pair.sigma_m, E_prime});
  for (const double separation : {1.0e-6, 1.5e-6, 2.0e-6}) {
    double pressure = 0, slope = 0;
    law.pressure(separation, pressure, slope);
    std::printf("contact pressure at %.1f um: %.3g MPa\n", 1e6 * separation, 1e-6 * pressure);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: surface RING LINER\n");
    return 2;
  }
  try {
    compute(argv[1], argv[2]);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
