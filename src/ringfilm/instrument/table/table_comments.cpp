#include "ringfilm/instrument/table/table_comments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "ringfilm/base/trimmed.hpp"
#include "ringfilm/io/table/table_head.hpp"
#include "ringfilm/io/table/text_cells.hpp"
#include "ringfilm/io/text/units.hpp"

namespace ringfilm::instrument {

using io::lower;
using io::number_of;

namespace {

/// As Gwyddion writes its four comments in the languages of its interface; ASCII letters in lower case.
constexpr std::string_view kChannel[] = {"channel", "kanál", "kanal", "canal", "canale", "チャネル", "채널", "Канал"};
constexpr std::string_view kWidth[] = {"width",   "breite", "anchura", "largeur", "larghezza",
                                       "largura", "Šířka",  "Ширина",  "幅",      "폭"};
constexpr std::string_view kHeight[] = {"height", "höhe",   "altura", "hauteur", "altezza",
                                        "výška",  "Высота", "高さ",   "높이"};
constexpr std::string_view kValueUnits[] = {"value units", "werteinheiten",     "einheiten",        "jednotky hodnot",
                                            "unités",      "unités de valeur",  "unità valore",     "値の単位",
                                            "값 단위",     "unidades de valor", "Единицы измерения"};

/// Half a unit of the last digit that a number was written with.
double rounding_of(std::string_view number) {
  const std::size_t power = std::min(number.find_first_of("eE"), number.size());
  const std::size_t point = number.substr(0, power).find_first_of(".,");
  const double decimals = point == std::string_view::npos ? 0 : static_cast<double>(power - point - 1);
  const double exponent = power < number.size() ? number_of(number.substr(power + 1), false).value_or(0) : 0;
  return 0.5 * std::pow(10.0, exponent - decimals);
}

/// A stated length in metres; nothing where its unit is not a length.
std::optional<StatedLength> in_metres(const StatedLength& length, const io::Units& units) {
  if (!units.measures(length.unit, "m")) return std::nullopt;
  const Scale scale = units.scale(length.unit, "m");
  return StatedLength{scale.to_si(length.value), scale.to_si(length.rounding), "m"};
}

/// Gwyddion writes each side in a unit that suits its size: "Width: 10 um", "Height: 10 mm".
void share_unit_of_sides(StatedMap& map) {
  if (!map.width || !map.height || map.width->unit == map.height->unit) return;
  const io::Units units;
  const std::optional<StatedLength> width = in_metres(*map.width, units), height = in_metres(*map.height, units);
  if (!width || !height) return;
  map.width = width;
  map.height = height;
}

}  // namespace

TableComments::TableComments(std::string file, const std::vector<io::TextLine>& comments) : file_(std::move(file)) {
  for (const io::TextLine& comment : comments) {
    const std::optional<io::CommentEntry> entry = io::comment_entry(comment.text);
    if (entry) entries_.push_back({entry->name, lower(entry->name), entry->value, comment.number, comment.text});
  }
}

const TableComments::Entry* TableComments::find(std::string_view key) const {
  const auto found =
      std::find_if(entries_.begin(), entries_.end(), [key](const Entry& entry) { return entry.key == key; });
  return found == entries_.end() ? nullptr : &*found;
}

/// What is wrong with a side is reported where the step of the map is needed.
/// @param usual_unit where the comment states none; may be empty
std::optional<StatedLength> TableComments::side(const Entry& entry, const std::string& usual_unit,
                                                StatedMap& map) const {
  const std::size_t blank = entry.value.find(' ');
  const std::string_view number = std::string_view(entry.value).substr(0, blank);
  const std::optional<double> length = number_of(number, true);
  if (!length || (blank == std::string::npos && usual_unit.empty())) return std::nullopt;
  const std::string unit =
      blank == std::string::npos ? usual_unit : trimmed(std::string_view(entry.value).substr(blank));
  const StatedLength side{*length, rounding_of(number), unit};
  std::string wrong;
  if (!(*length > 0)) {
    wrong = fmt::format("{} is {}, but the side of a map is longer than 0", entry.name, entry.value);
  } else if (const io::Units units; units.measures(side.unit, "s")) {
    wrong = fmt::format("{} is {}, a time and not a length", entry.name, entry.value);
  } else if (!units.measures(side.unit, "m")) {
    wrong = fmt::format("{} is {}, and \"{}\" is not a unit of length", entry.name, entry.value, side.unit);
  }
  if (wrong.empty()) return side;
  Fault fault;
  fault.mark = SourceMark{file_, entry.number, 1, entry.line};
  fault.message = wrong;
  fault.remedy = "correct the header of the file";
  map.faults.push_back(std::move(fault));
  return side;
}

StatedMap TableComments::stated() const {
  StatedMap map;
  const auto one_of = [this](const auto& keys) {
    const Entry* found = nullptr;
    for (const std::string_view key : keys) found = found != nullptr ? found : find(key);
    return found;
  };
  if (const Entry* const name = one_of(kChannel)) map.name = name->value;
  if (const Entry* const unit = one_of(kValueUnits)) map.unit = unit->value;
  const auto take_side = [&](const Entry* entry, const std::string& usual_unit, std::optional<StatedLength>& side_of) {
    if (entry != nullptr) side_of = side(*entry, usual_unit, map);
  };
  take_side(one_of(kWidth), "", map.width);
  take_side(one_of(kHeight), "", map.height);

  // SPIP states lengths in nm, and the unit of the heights or how many nm one bit is.
  const Entry* const bit = find("bit2nm");
  const bool is_spip =
      bit != nullptr || (find("file format") != nullptr && lower(find("file format")->value) == "ascii");
  const auto unit_along = [&](const char* key) {
    const Entry* const unit = find(key);
    return unit != nullptr ? unit->value : std::string(is_spip ? "nm" : "");
  };
  if (!map.width) take_side(find("x-length"), unit_along("x-unit"), map.width);
  if (!map.height) take_side(find("y-length"), unit_along("y-unit"), map.height);
  if (map.unit.empty() && find("z-unit") != nullptr) map.unit = find("z-unit")->value;
  const std::optional<double> nm = bit != nullptr ? number_of(bit->value, true) : std::nullopt;
  if (nm && *nm > 0 && map.unit.empty()) {
    map.unit = "nm";
    map.height_factor = *nm;
    map.notes.push_back(fmt::format("the numbers of the file times Bit2nm = {} are heights in nm", bit->value));
  } else if (nm && *nm != 1) {
    map.doubts.push_back({fmt::format("line {} states Bit2nm = {}, which was not used: the heights are taken in {}",
                                      bit->number, bit->value, map.unit.empty() ? "the stated unit" : map.unit),
                          "if the numbers are bits, remove the other unit of the heights"});
  }
  const auto count = [this](const char* key) -> std::optional<std::size_t> {
    const Entry* const entry = find(key);
    const std::optional<double> number = entry != nullptr ? number_of(entry->value, false) : std::nullopt;
    if (!number || !(*number >= 1) || *number > 1e9) return std::nullopt;
    return static_cast<std::size_t>(*number);
  };
  map.points_x = count("x-pixels");
  map.points_y = count("y-pixels");
  share_unit_of_sides(map);
  return map;
}

}  // namespace ringfilm::instrument
