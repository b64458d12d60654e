#include "measured_files.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "measured_chain.hpp"
#include "ringfilm/io/case/case_file.hpp"

namespace ringfilm::measured_files {

std::vector<TargetRing> target_rings(const std::string& cases) {
  const io::Units units;
  std::vector<TargetRing> rings;
  for (const std::string name : app::chain::kRings) {
    std::string case_name = name;
    std::replace(case_name.begin(), case_name.end(), '_', '-');
    const cycle::Case c = io::read_case(cases + "/styles2014/" + case_name + ".toml", {}, units);
    rings.push_back({name, c.contact.asperity_density, c.contact.asperity_radius, c.contact.roughness,
                     c.contact.boundary_shear_strength_coefficient, c.ring.face.coefficients});
  }
  return rings;
}

std::vector<GeneratedFile> all_files(const std::string& cases) {
  const std::vector<TargetRing> rings = target_rings(cases);
  std::vector<GeneratedFile> files;
  for (auto* of : {&surface_files, &face_files, &loop_files}) {
    std::vector<GeneratedFile> made = of(rings);
    std::move(made.begin(), made.end(), std::back_inserter(files));
  }
  return files;
}

}  // namespace ringfilm::measured_files
