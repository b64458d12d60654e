// Friction, film and roughness of a ring over its running hours.
//   life LIFE.toml
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "ringfilm/ringfilm.hpp"

namespace {

using namespace ringfilm;

/// Place of a value in life::LifeValues.
std::size_t place(std::string_view name) {
  const std::vector<life::LifeQuantity>& all = life::life_quantities();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].name == name) return i;
  }
  throw std::logic_error("a life has no such value");
}

void compute(const char* life_path) {
  const io::LifeFile file = io::read_life(life_path);
  const life::LifeResult result = life::run_life(file.life, study::cycle_integrators({}));
  for (const life::LifeState& state : result.states) {
    std::printf("%.0f h: %.2f kPa, film %.2f um, roughness %.2f um\n", state.time / 3600,
                1e-3 * state.values[place("fmep")], 1e6 * state.values[place("min_film_thickness")],
                1e6 * state.ring.roughness);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: life LIFE.toml\n");
    return 2;
  }
  try {
    compute(argv[1]);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
