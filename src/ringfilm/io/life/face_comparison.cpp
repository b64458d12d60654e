#include "ringfilm/io/life/face_comparison.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "ringfilm/base/display.hpp"
#include "ringfilm/io/case/case_file.hpp"
#include "ringfilm/io/result/record_json.hpp"

namespace ringfilm::io {
namespace {

using life::Tilt;
using nlohmann::ordered_json;

NamedFace read_face(const std::string& path) {
  const cycle::Case c = read_case(path);
  if (c.problem == cycle::Problem::kPad || c.is_pack()) {
    throw InputError(path + " is not a case of one ring", "name cases with [ring.face]");
  }
  return {std::filesystem::path(path).stem().string(), life::face_heights(c)};
}

FacePair compared(const NamedFace& earlier, const NamedFace& later) {
  FacePair pair{earlier.name, later.name, {}, {}, {}};
  for (const double share : life::trusted_margins()) {
    const double margin = share * earlier.face.width();
    pair.level.push_back(least_wear(earlier.face, later.face, margin, Tilt::kNone));
    pair.tilted.push_back(least_wear(earlier.face, later.face, margin, Tilt::kFree));
    pair.turned.push_back(least_wear(earlier.face, life::turned(later.face), margin, Tilt::kFree));
  }
  return pair;
}

}  // namespace

FaceComparison read_face_comparison(const std::vector<std::string>& case_paths) {
  if (case_paths.size() < 2) {
    throw InputError("wear is a difference of faces, and " + std::to_string(case_paths.size()) + " is named",
                     "for example ringfilm life faces new.toml run-in.toml embedded.toml");
  }
  FaceComparison comparison;
  for (const std::string& path : case_paths) comparison.faces.push_back(read_face(path));
  const std::vector<NamedFace>& faces = comparison.faces;
  for (const NamedFace& one : faces) {
    if (one.face.width() == faces.front().face.width()) continue;
    throw InputError(
        fmt::format("the face of {} is {} wide, that of {} {}", one.name, text_in(one.face.width(), kMillimetre),
                    faces.front().name, text_in(faces.front().face.width(), kMillimetre)),
        "compare faces of one ring");
  }
  for (const NamedFace& one : faces) comparison.concave.push_back(concave_stretches(one.face, kNoticedConcavity));
  for (std::size_t i = 1; i < faces.size(); ++i) comparison.pairs.push_back(compared(faces[i - 1], faces[i]));
  if (faces.size() > 2) comparison.pairs.push_back(compared(faces.front(), faces.back()));
  return comparison;
}

std::string face_comparison_json(const FaceComparison& comparison) {
  ordered_json object = {{"faces", ordered_json::array()}, {"pairs", ordered_json::array()}};
  for (std::size_t i = 0; i < comparison.faces.size(); ++i) {
    ordered_json stretches = ordered_json::array();
    for (const life::ConcaveStretch& stretch : comparison.concave[i]) {
      stretches.push_back({{"from", stretch.from}, {"to", stretch.to}, {"height", stretch.height}});
    }
    object["faces"].push_back({{"name", comparison.faces[i].name}, {"concave", stretches}});
  }
  for (const FacePair& pair : comparison.pairs) {
    object["pairs"].push_back({{"earlier", pair.earlier},
                               {"later", pair.later},
                               {"level", record_array(pair.level)},
                               {"tilted", record_array(pair.tilted)},
                               {"turned", record_array(pair.turned)}});
  }
  put_member_units<life::WearBound>(object["units"]);
  for (const char* name : {"from", "to", "height"}) object["units"][name] = "m";
  object["notes"] = {"lower bounds: more wear is always possible, and what the edges lost must be added to the middle"};
  return json_text(object);
}

}  // namespace ringfilm::io
