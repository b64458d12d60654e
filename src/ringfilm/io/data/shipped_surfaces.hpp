#pragma once
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/io/text/source_text.hpp"
#include "ringfilm/io/text/units.hpp"
#include "ringfilm/models/contact/plateau.hpp"

/// Classes of surfaces of liners and rings in data/pairs of the shipped folder.
namespace ringfilm::io {

/// The file, as a case anywhere names it.
inline constexpr const char* kSurfacesFile = "data/pairs/surfaces.toml";

/// A class of liners in one state.
struct LinerSurface {
  std::string name;                      ///< name of the class, "plateau-honed-grey-iron"
  std::string state;                     ///< "new", "run-in" or "worn"
  models::PlateauCurve plateau{};        ///< lines of the material ratio curve
  std::optional<double> hardness;        ///< hardness of the running surface [Pa]
  std::optional<double> youngs_modulus;  ///< Young's modulus of the running surface [Pa]
  std::string source;                    ///< or "typical, assumed"
};

/// A class of ring faces in one state.
struct RingSurface {
  std::string name;      ///< name of the class, "nitrided"
  std::string state;     ///< "new", "run-in" or "worn"
  double roughness = 0;  ///< rms height Rq of the face [m]
  std::string source;    ///< or "typical, assumed"
};

/// The classes of a file and its digest.
struct SurfaceClasses {
  std::vector<LinerSurface> liners;
  std::vector<RingSurface> rings;
  std::string sha256;
};

/// Reads classes. Liners state Rpq, Rvq and Rmq, or Rk, Rpk, Rvk and Mr2, of which the lines are made
/// (eq-plateau-core). Throws InputError with the faults of the file: keys that are unknown or missing, Rpq that is not
/// below Rvq, a ratio outside 0 to 1, a name that comes twice in one state.
SurfaceClasses read_surfaces(const NamedFile& file, const Units& units);

/// The shipped ones. Throws InputError where the shipped folder is not found.
SurfaceClasses shipped_surfaces(const Units& units);

/// The liner of a name and a state. Throws InputError that lists the names, or the states of this one.
LinerSurface liner_of_name(const SurfaceClasses& all, const std::string& name, const std::string& state);
/// The ring of a name and a state. Throws InputError that lists the names, or the states of this one.
RingSurface ring_of_name(const SurfaceClasses& all, const std::string& name, const std::string& state);

/// The lists of liners and of rings for a terminal (`ringfilm pairs`).
std::string surfaces_table(const SurfaceClasses& all);

}  // namespace ringfilm::io
