#include "ringfilm/io/text/document_kind.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace ringfilm::io {
namespace {

struct KnownKind {
  DocumentKind kind;
  std::string name;               ///< with its article
  std::string use;                ///< where such a file is named; "{}" is its path
  std::vector<std::string> keys;  ///< at the top of such a file and of no other kind
};

const std::vector<KnownKind>& kinds() {
  static const std::vector<KnownKind> all = {
      {DocumentKind::kCase,
       "a case",
       "compute it with ringfilm run {}",
       {"engine", "operating", "gas", "gas_path", "thermal", "ring", "liner", "contact", "lubricant", "film", "supply",
        "evaporation", "oil_transport", "solver", "output", "pad", "conform", "conditions", "include"}},
      {DocumentKind::kStudy,
       "a study",
       "compute it with ringfilm study {} --output FOLDER",
       {"base", "factor", "measured", "correlation", "plan", "point", "keep", "compute"}},
      {DocumentKind::kLife,
       "a life",
       "compute it with ringfilm life {}",
       {"hours", "state", "wear", "duty", "report_point", "end_of_life"}},
      {DocumentKind::kOil,
       "an oil",
       "a case names it: lubricant.file = \"{}\"",
       {"kinematic_viscosity", "density", "pressure_viscosity_coefficient", "hths_viscosity"}},
      {DocumentKind::kFit, "a fit", "compute it with ringfilm fit {}", {"parameter", "fit", "case"}},
      {DocumentKind::kOptimisation,
       "an optimisation",
       "compute it with ringfilm optimise {}",
       {"objective", "constraint", "variable", "optimise", "case"}}};
  return all;
}

bool has_key_of(const TomlValue& root, const KnownKind& kind) {
  return std::ranges::any_of(root.members, [&](const TomlMember& member) {
    return std::ranges::find(kind.keys, member.key) != kind.keys.end();
  });
}

}  // namespace

void check_document_kind(const TomlValue& root, DocumentKind expected, const std::string& path) {
  const auto of_kind = std::ranges::find(kinds(), expected, &KnownKind::kind);
  if (has_key_of(root, *of_kind)) return;
  for (const KnownKind& kind : kinds()) {
    if (!has_key_of(root, kind)) continue;
    throw InputError(
        std::vector<Fault>{{{path, 0, 0, ""},
                            "this file is " + kind.name + ", not " + of_kind->name,
                            fmt::format(fmt::runtime(kind.use), path) + "; name " + of_kind->name + " here"}});
  }
}

}  // namespace ringfilm::io
