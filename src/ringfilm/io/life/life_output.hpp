#pragma once
#include <string>

#include "ringfilm/io/life/life_file.hpp"
#include "ringfilm/io/result/result_file.hpp"
#include "ringfilm/life/life_result.hpp"

namespace ringfilm::io {

/// A life with what it gave.
struct LifeDocument {
  LifeFile file;            ///< as it was read
  life::LifeResult result;  ///< values over the running time
  Provenance provenance;    ///< program, commit and kernels
};

/// The life as one JSON object, SI, running times in hours: title, mode, and a list `states` with, for each reported
/// time, `hours`, `state_origin`, `worn_area`, `largest_worn_depth` (null where the mode does not determine them),
/// every value of life::life_quantities() of the whole duty by its name, face, roughness and shear strength, `band`,
/// `turned`, `attribution` and `points`; then `interpolations`, `units`, `notes`, `program`, `commit`, `kernels`.
std::string life_json(const LifeDocument& document);

/// Writes NetCDF-4 over the dimension running_time (hours): every value of the duty, its band, the values of the
/// operating points, the face over (running_time, x). Written aside first, then renamed. Throws OutputError.
void write_life(const std::string& path, const LifeDocument& document);

/// How the state of a running time is known, in a word: "measured", "interpolated", "held".
std::string state_origin_word(life::StateOrigin state_origin);

}  // namespace ringfilm::io
