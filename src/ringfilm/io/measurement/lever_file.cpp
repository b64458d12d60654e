#include "ringfilm/io/measurement/lever_file.hpp"

#include <utility>
#include <vector>

#include "ringfilm/io/text/toml_table.hpp"
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

void read_size(const Size& size, LoadUnit load_unit, const Units& units, TomlTable& table, Lever& lever) {
  const TomlValue* value = table.find(size.key);
  const SourceMark file{table.mark().file, 0, 0, ""};
  if (value == nullptr) {
    if (size.need == LeverNeed::kAlways) {
      table.refuse(file, size.key + " is missing", "for example " + size.example);
    } else if (size.need == LeverNeed::kForNewtons && load_unit == LoadUnit::kNewton) {
      table.refuse(file, size.key + " is missing: the loads are in newtons",
                   "for example " + size.example + "; for loads in volts it is not needed");
    }
  } else if (value->is_number() && size.si_unit == "1") {
    lever.*size.member = {value->number, 0};
  } else if (value->kind == TomlValue::Kind::kText) {
    try {
      lever.*size.member = uncertain_quantity(value->text, size.si_unit, size.example, units);
    } catch (const UnitError& problem) {
      table.refuse_value(size.key, problem.what(), problem.remedy);
    }
  } else {
    table.refuse_value(size.key, value->is_number() ? "has no unit" : "is not a text", "for example " + size.example);
  }
}

}  // namespace

LeverFile read_lever(const NamedFile& file, LoadUnit load_unit, const Units& units) {
  const SourceText source = read_source_text(file.path, file.shown, kMaxToml);
  const TomlValue root = parse_toml(source);
  std::vector<Fault> faults;
  std::vector<std::string> known = {"shape"};
  for (const Size& size : sizes()) known.push_back(size.key);
  TomlTable table(root, "a lever", known, faults);
  LeverFile read{{}, source.sha256};
  table.need("shape", "\"rectangular\"");
  table.choose("shape", {{"rectangular", LeverShape::kRectangular}, {"v-shaped", LeverShape::kVShaped}},
               read.lever.shape);
  for (const Size& size : sizes()) read_size(size, load_unit, units, table, read.lever);
  if (!faults.empty()) throw InputError(std::move(faults));
  return read;
}

}  // namespace ringfilm::io
