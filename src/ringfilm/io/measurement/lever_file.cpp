#include "ringfilm/io/measurement/lever_file.hpp"

#include <algorithm>
#include <vector>

#include "ringfilm/base/error.hpp"
#include "ringfilm/io/text/suggestion.hpp"
#include "ringfilm/io/text/toml_tree.hpp"
#include "ringfilm/io/text/uncertain_quantity.hpp"

namespace ringfilm::io {
namespace {

using surface::Lever;
using surface::LeverShape;
using surface::LoadUnit;
using surface::Uncertain;

enum class LeverNeed { kAlways, kForNewtons, kNever };

struct Size {
  std::string key, si_unit, example;
  LeverNeed need;
  Uncertain Lever::*member;
};

std::vector<Size> sizes() {
  return {{"length", "m", "\"450 um +- 5 um\"", LeverNeed::kAlways, &Lever::length_m},
          {"tip_height", "m", "\"17 um +- 1 um\"", LeverNeed::kAlways, &Lever::tip_height_m},
          {"poissons_ratio", "1", "\"0.27 +- 0.02\"", LeverNeed::kAlways, &Lever::poissons_ratio},
          {"sensitivity_ratio", "1", "\"1 +- 0.05\"", LeverNeed::kNever, &Lever::sensitivity_ratio},
          {"youngs_modulus", "Pa", "\"169 GPa +- 5 GPa\"", LeverNeed::kForNewtons, &Lever::youngs_modulus_Pa},
          {"width", "m", "\"50 um +- 2 um\"", LeverNeed::kForNewtons, &Lever::width_m},
          {"thickness", "m", "\"2 um +- 0.1 um\"", LeverNeed::kForNewtons, &Lever::thickness_m},
          {"torsional_sensitivity", "V/m", "\"0.05 V/nm +- 5 %\"", LeverNeed::kForNewtons,
           &Lever::torsional_sensitivity_V_per_m}};
}

class LeverReader {
 public:
  LeverReader(const NamedFile& file, LoadUnit load_unit, const Units& units)
      : source_(read_source_text(file.path, file.shown, kLargestToml)),
        root_(parse_toml(source_)),
        load_unit_(load_unit),
        units_(units) {}

  LeverFile read() {
    LeverFile file;
    file.sha256 = source_.sha256;
    refuse_unknown();
    read_shape(file.lever);
    for (const Size& size : sizes()) read_size(size, file.lever);
    if (!faults_.empty()) throw InputError(faults_);
    return file;
  }

 private:
  const TomlValue* find(const std::string& key) const {
    for (const auto& [name, value] : root_.members) {
      if (name == key) return &value;
    }
    return nullptr;
  }

  void refuse_unknown() {
    std::vector<std::string> known = {"shape"};
    for (const Size& size : sizes()) known.push_back(size.key);
    for (const auto& [key, value] : root_.members) {
      if (std::find(known.begin(), known.end(), key) != known.end()) continue;
      const std::string near = nearest_word(key, known);
      std::string names;
      for (const std::string& name : known) names += (names.empty() ? "" : ", ") + name;
      faults_.push_back({value.key_mark, "unknown key " + key,
                         near.empty() ? "a lever has the keys " + names : "did you mean " + near + "?"});
    }
  }

  void read_shape(Lever& lever) {
    const TomlValue* shape = find("shape");
    if (shape == nullptr) {
      faults_.push_back({source_.mark(0), "shape is missing", "\"rectangular\" or \"v-shaped\""});
    } else if (shape->text == "rectangular" || shape->text == "v-shaped") {
      lever.shape = shape->text == "rectangular" ? LeverShape::kRectangular : LeverShape::kVShaped;
    } else {
      faults_.push_back(
          {shape->mark, "shape = " + shape->as_written() + " is unknown", "\"rectangular\" or \"v-shaped\""});
    }
  }

  void read_size(const Size& size, Lever& lever) {
    const TomlValue* value = find(size.key);
    if (value == nullptr) {
      if (size.need == LeverNeed::kAlways) {
        faults_.push_back({source_.mark(0), size.key + " is missing", "for example " + size.example});
      } else if (size.need == LeverNeed::kForNewtons && load_unit_ == LoadUnit::kNewton) {
        faults_.push_back({source_.mark(0), size.key + " is missing: the loads are in newtons",
                           "for example " + size.example + "; for loads in volts it is not needed"});
      }
      return;
    }
    const bool number = value->kind == TomlValue::Kind::kNumber || value->kind == TomlValue::Kind::kInteger;
    if (number && size.si_unit == "1") {
      lever.*size.member = {value->number, 0};
    } else if (value->kind == TomlValue::Kind::kText) {
      read_text(size, *value, lever);
    } else {
      faults_.push_back({value->mark,
                         size.key + " = " + value->as_written() + (number ? " has no unit" : " is not a text"),
                         "for example " + size.example});
    }
  }

  void read_text(const Size& size, const TomlValue& value, Lever& lever) {
    try {
      lever.*size.member = uncertain_quantity(value.text, size.si_unit, size.example, units_);
    } catch (const UnitError& problem) {
      faults_.push_back({value.mark, size.key + " = " + value.as_written() + " " + problem.what(), problem.remedy});
    }
  }

  SourceText source_;
  TomlValue root_;
  LoadUnit load_unit_;
  const Units& units_;
  std::vector<Fault> faults_;
};

}  // namespace

LeverFile read_lever(const NamedFile& file, LoadUnit load_unit, const Units& units) {
  return LeverReader(file, load_unit, units).read();
}

}  // namespace ringfilm::io
