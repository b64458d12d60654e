#include "ringfilm/instrument/surface_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>

#include "ringfilm/base/error.hpp"
#include "ringfilm/instrument/formats/digital_surf_file.hpp"
#include "ringfilm/instrument/formats/gwy_file.hpp"
#include "ringfilm/instrument/formats/gwyddion_program.hpp"
#include "ringfilm/instrument/formats/sdf_file.hpp"
#include "ringfilm/instrument/formats/simple_field_file.hpp"
#include "ringfilm/instrument/formats/smd_file.hpp"
#include "ringfilm/instrument/formats/trade_table_file.hpp"
#include "ringfilm/instrument/formats/x3p_file.hpp"
#include "ringfilm/instrument/grid/binary_reader.hpp"
#include "ringfilm/instrument/grid/even_places.hpp"
#include "ringfilm/instrument/grid/height_checks.hpp"
#include "ringfilm/instrument/grid/number_from.hpp"
#include "ringfilm/instrument/grid/regular_grid.hpp"
#include "ringfilm/io/storage/digest.hpp"
#include "ringfilm/io/storage/digest_trailer.hpp"
#include "ringfilm/io/text/foreign_file.hpp"
#include "ringfilm/io/text/text_encoding.hpp"

namespace ringfilm::instrument {
namespace {

/// No rough surface is that high: a wrong unit or a wrong byte order is.
constexpr double kHighest_m = 1.0;

InstrumentFile through_gwyddion(const std::string& path) {
  InstrumentFile result = read_gwy(path, converted_by_gwyddion(path));
  const std::size_t source = result.format.find("read by gwyddion");
  result.format = source == std::string::npos ? "read by gwyddion" : result.format.substr(source);
  return result;
}

/// Refuses text that is not a table of heights, nor of a format that gwyddion reads.
[[noreturn]] void refuse_text(const std::string& path, const TextHead& head, const InputError& of_gwyddion) {
  const std::string numbers =
      head.numbers_line > 1
          ? fmt::format(
                "; the numbers seem to begin in line {}: --skip-lines {} skips the lines before them, and "
                "--columns \"x [um], z [um]\" names all columns, - one that is not used",
                head.numbers_line, head.numbers_line - 1)
          : "";
  throw InputError(std::vector<Fault>{
      {{path, head.line, 1, head.words},
       "this line starts neither numbers nor columns of heights, and " + of_gwyddion.faults().front().message,
       "text is read as a matrix of heights, as points x, y, z, or as a profile x, z. Write the heights of a matrix "
       "alone, without numbers of rows, axes or counts, or name the columns in the first line, for example: "
       "x [um],y [um],z [nm]; start any other line before them with #" +
           numbers}});
}

bool is_text_format(const std::string& format) { return format.starts_with("text, "); }

InstrumentFile text_through_gwyddion(const std::string& path, const TextHead& head) {
  try {
    return through_gwyddion(path);
  } catch (const InputError& error) {
    refuse_text(path, head, error);
  }
}

bool starts_with(const std::string& bytes, std::string_view signature) {
  return std::string_view(bytes).substr(0, signature.size()) == signature;
}

bool is_length(const std::string& unit, const io::Units& units) { return !unit.empty() && units.measures(unit, "m"); }

std::size_t channel_by_text(const InstrumentFile& file, const std::string& path, const SurfaceOptions& options) {
  const std::string& text = *options.channel;
  const ChannelFound found = find_channel(file.channels, text);
  if (found.n_named > 1) {
    refuse(path, fmt::format("{} channels are named \"{}\":\n{}", found.n_named, text, channel_list(file.channels)),
           "choose one by its number: " + options.names.channel);
  }
  if (found.index) return *found.index;
  refuse(path, fmt::format("there is no channel {} among:\n{}", text, channel_list(file.channels)),
         "choose one of them: " + options.names.channel);
}

std::size_t chosen_channel(const InstrumentFile& file, const std::string& path, const SurfaceOptions& options,
                           const io::Units& units, std::vector<std::string>& notes) {
  if (options.channel) return channel_by_text(file, path, options);
  if (file.channels.size() == 1) return 0;
  std::vector<std::size_t> heights;
  for (std::size_t i = 0; i < file.channels.size(); ++i) {
    if (is_length(file.channels[i].unit, units)) heights.push_back(i);
  }
  if (heights.size() != 1) {
    refuse(path,
           fmt::format("the file has {} channels, {} of them in a unit of length:\n{}", file.channels.size(),
                       heights.empty() ? "none" : std::to_string(heights.size()), channel_list(file.channels)),
           "choose one: " + options.names.channel);
  }
  notes.push_back(fmt::format("channel {} ({}) of {} was taken: the only one in a unit of length", heights[0] + 1,
                              file.channels[heights[0]].name, file.channels.size()));
  return heights[0];
}

/// What is known of the reading besides the heights.
struct Record {
  std::vector<std::string>& notes;
  std::vector<Doubt>& doubts;
};

/// The scale of a unit of length to metres.
Scale length_scale(const std::string& path, const std::string& unit, const std::string& what, const std::string& remedy,
                   const io::Units& units) {
  if (!is_length(unit, units))
    refuse(path, fmt::format("{} \"{}\", which is not a unit of length", what, unit), remedy);
  return units.scale(unit, "m");
}

/// The user's unit in place of that of the file. Where both are lengths of one size the file is not contradicted.
Doubt against_unit(const std::string& what, const std::string& stated, const std::string& taken) {
  return {fmt::format("the file states {} in {}, and {} is used in its place, as the user states", what, stated, taken),
          "omit the unit where the file is right"};
}

bool same_unit(const std::string& a, const std::string& b, const io::Units& units) {
  return a == b ||
         (is_length(a, units) && is_length(b, units) && units.scale(a, "m").to_si(1) == units.scale(b, "m").to_si(1));
}

/// The unit of a list whose x, y and z have one: that of x and y if the user states it, else the assumed one.
Scale assumed_scale(const std::string& path, const ChannelValues& values, const SurfaceOptions& options,
                    const io::Units& units, Record& record) {
  if (options.lateral_unit) {
    record.notes.push_back(fmt::format("unit of heights: {}, as that of x and y", *options.lateral_unit));
    return length_scale(path, *options.lateral_unit, "the stated unit of x and y is",
                        "give a length, for example " + options.names.lateral_unit, units);
  }
  record.doubts.push_back(
      {fmt::format("the file states no unit: {0} was assumed for x, y and z, which makes steps of {1:.6g} {0}",
                   values.assumed_unit, values.step_x),
       "if it is another one, state it, for example " + options.names.height_unit});
  return units.scale(values.assumed_unit, "m");
}

Scale height_scale(const std::string& path, const ChannelValues& values, const SurfaceOptions& options,
                   const io::Units& units, Record& record) {
  const std::string& stated = values.channel.unit;
  if (options.height_unit) {
    const Scale scale = length_scale(path, *options.height_unit, "the stated unit of heights is",
                                     "give a length, for example " + options.names.height_unit, units);
    record.notes.push_back(fmt::format("unit of heights: {} as the user states", *options.height_unit));
    if (!stated.empty() && !same_unit(stated, *options.height_unit, units)) {
      record.doubts.push_back(against_unit("the heights", stated, *options.height_unit));
    }
    return scale;
  }
  if (stated.empty() && !values.assumed_unit.empty()) return assumed_scale(path, values, options, units, record);
  if (stated.empty()) {
    refuse(path, fmt::format("the file does not state in which unit channel \"{}\" is", values.channel.name),
           "state it, for example " + options.names.height_unit);
  }
  return length_scale(path, stated, fmt::format("channel \"{}\" is in", values.channel.name),
                      fmt::format("choose a channel of heights with {}; where the unit is wrong, state it: {}",
                                  options.names.channel, options.names.height_unit),
                      units);
}

double length_of_user(const std::string& path, const std::string& text, const std::string& option,
                      const io::Units& units) {
  try {
    const double length = units.quantity(text, "m", "0.5 um");
    if (length > 0) return length;
    refuse(path, fmt::format("{} {} is not a step", option, text), "a length above zero is required");
  } catch (const io::UnitError& error) {
    refuse(path, fmt::format("{} \"{}\" {}", option, text, error.what()), error.remedy);
  }
}

/// Do the places count the points, 0, 1, 2 or 1, 2, 3?
bool count_points(const std::vector<double>& places) {
  if (places.size() < 3 || (places[0] != 0 && places[0] != 1)) return false;
  for (std::size_t i = 1; i < places.size(); ++i) {
    if (places[i] != places[0] + static_cast<double>(i)) return false;
  }
  return true;
}

/// The scale of places and steps to metres.
Scale lateral_scale(const std::string& path, const ChannelValues& values, const SurfaceOptions& options,
                    const io::Units& units, Record& record) {
  if (options.lateral_unit) {
    record.notes.push_back(fmt::format("unit of x and y: {} as the user states", *options.lateral_unit));
    if (!values.step_unit.empty() && !same_unit(values.step_unit, *options.lateral_unit, units)) {
      record.doubts.push_back(against_unit("x and y", values.step_unit, *options.lateral_unit));
    } else if (values.step_unit.empty() && count_points(values.x)) {
      record.doubts.push_back({fmt::format("x counts {:g}, {:g}, {:g} ... and was taken as places in {}", values.x[0],
                                           values.x[1], values.x[2], *options.lateral_unit),
                               "if it numbers the points, state their step, for example " + options.names.step_x});
    }
    return length_scale(path, *options.lateral_unit, "the stated unit of x and y is",
                        "give a length, for example " + options.names.lateral_unit, units);
  }
  if (values.step_unit.empty() && !values.assumed_unit.empty()) {
    if (options.height_unit) {
      record.notes.push_back(fmt::format("unit of x and y: {}, as that of the heights", *options.height_unit));
    }
    return units.scale(options.height_unit.value_or(values.assumed_unit), "m");
  }
  if (values.step_unit.empty()) {
    refuse(path, "the file does not state in which unit x and y are",
           "state it, for example " + options.names.lateral_unit);
  }
  return length_scale(path, values.step_unit, values.step_unit_y.empty() ? "x and y are in" : "x is in",
                      "state the step, for example " + options.names.step_x, units);
}

/// The scale of the step along y, whose unit may be another one than that of x.
Scale scale_along_y(const std::string& path, const ChannelValues& values, const SurfaceOptions& options,
                    const io::Units& units, const Scale& along_x) {
  if (values.step_unit_y.empty() || options.lateral_unit) return along_x;
  return length_scale(path, values.step_unit_y, "y is in", "state the step, for example " + options.names.step_x,
                      units);
}

/// The step of places that are even, and a doubt where the user's step replaces places that are not.
void set_step_of_places(ChannelValues& values, const SurfaceOptions& options, Record& record) {
  if (values.x.empty()) return;
  values.step_x = even_step(values.x);
  if (values.step_x > 0 || !options.step_x) return;
  record.doubts.push_back(
      {fmt::format("the places of the file are not even, and steps of {} are used in their place, as "
                   "the user states",
                   *options.step_x),
       "omit the step where the file is right"});
}

struct Steps {
  double x_m = 0;
  double y_m = 0;
};

constexpr double kSameStep = 1e-3;  // relative: files write steps with few digits

/// The step that the user states. One that the file contradicts is a doubt.
double stated_step(const std::string& path, const std::string& text, const char* axis, double of_file,
                   const std::string& unit, const io::Units& units, Record& record) {
  const double step_m = length_of_user(path, text, fmt::format("the step along {}", axis), units);
  record.notes.push_back(fmt::format("step {}: {} as the user states", axis, text));
  if (!(of_file > 0) || !is_length(unit, units)) return step_m;
  if (std::abs(units.scale(unit, "m").to_si(of_file) / step_m - 1) > kSameStep) {
    record.doubts.push_back(
        {fmt::format("the file states a step along {} of {:.6g} {}, and {} is used in its place, as "
                     "the user states",
                     axis, of_file, unit, text),
         "omit the step where the file is right"});
  }
  return step_m;
}

Steps steps_of(const std::string& path, const ChannelValues& values, const SurfaceOptions& options,
               const io::Units& units, Record& record) {
  const bool is_profile = values.channel.points_y == 1;
  Steps steps;
  const std::string& unit = values.step_unit;
  const std::string& unit_y = values.step_unit_y.empty() ? unit : values.step_unit_y;
  if (options.step_x) steps.x_m = stated_step(path, *options.step_x, "x", values.step_x, unit, units, record);
  if (options.step_y) {
    steps.y_m = stated_step(path, *options.step_y, "y", values.step_y, unit_y, units, record);
  } else if (options.step_x) {
    steps.y_m = is_profile ? steps.x_m : stated_step(path, *options.step_x, "y", values.step_y, unit_y, units, record);
  }
  const bool needs_x = steps.x_m == 0, needs_y = steps.y_m == 0 && !is_profile;
  if (needs_x || needs_y) {
    if (!values.step_faults.empty() && !options.lateral_unit) {
      std::vector<Fault> faults = values.step_faults;
      for (Fault& fault : faults) fault.remedy += ", or state the step, for example " + options.names.step_x;
      throw InputError(faults);
    }
    if ((needs_x && values.step_x == 0) || (needs_y && values.step_y == 0)) {
      refuse(path, "the file does not state the step between its points",
             "state it, for example " + options.names.step_x);
    }
    const Scale scale = lateral_scale(path, values, options, units, record);
    if (needs_x) steps.x_m = scale.to_si(values.step_x);
    if (needs_y) steps.y_m = scale_along_y(path, values, options, units, scale).to_si(values.step_y);
  }
  for (const double step : {steps.x_m, is_profile ? steps.x_m : steps.y_m}) {
    if (!std::isfinite(step) || !(step > 1e-13) || !(step < 1)) {
      refuse(path, fmt::format("{} m is not a valid step between points", step),
             "the header is damaged, or its unit or byte order is not the one it states");
    }
  }
  return steps;
}

/// A column of points is a profile that was stored upright.
void turn_column(ChannelValues& values) {
  if (values.channel.points_x != 1 || values.channel.points_y <= 1) return;
  std::swap(values.channel.points_x, values.channel.points_y);
  std::swap(values.step_x, values.step_y);
  if (!values.step_unit_y.empty()) std::swap(values.step_unit, values.step_unit_y);
  values.step_unit_y.clear();
  values.notes.push_back("the map has one column: it was read as a profile");
}

void scale_heights(const std::string& path, ChannelValues& values, const Scale& scale, const OptionNames& names) {
  double largest = 0;
  std::optional<std::size_t> highest;
  for (std::size_t i = 0; i < values.value.size(); ++i) {
    if (values.is_missing(i)) continue;
    values.value[i] = scale.to_si(values.value[i]);
    if (!std::isfinite(values.value[i])) {
      refuse(path, fmt::format("point {}: a height is not a finite number", i + 1),
             "the heights are damaged, or their byte order is not the one of the format");
    }
    if (!highest || std::abs(values.value[i]) > largest) highest = i;
    largest = std::max(largest, std::abs(values.value[i]));
  }
  if (!highest) refuse(path, "no point was measured: all are missing", "is it the right file or channel?");
  if (largest > kHighest_m) {
    refuse(path,
           fmt::format("the largest height is {:.4g} m, over {} m, in row {}, column {}", largest, kHighest_m,
                       *highest / values.channel.points_x + 1, *highest % values.channel.points_x + 1),
           fmt::format("the unit is wrong (state it: {}), the value marks a point without a height (write nan in its "
                       "place), or the heights are damaged or in another byte order",
                       names.height_unit));
  }
}

/// Two numbers in front of the heights of a profile, its length [mm] and how many heights follow, are its head where
/// they give the step that the user states.
void drop_length_and_count(ChannelValues& values, const SurfaceOptions& options, const io::Units& units) {
  constexpr std::size_t kHead = 2;
  const bool is_list = values.channel.points_y == 1 && values.x.empty() && values.step_x == 0;
  if (!is_list || !options.step_x || values.value.size() < kHead + 2) return;
  const auto count = static_cast<double>(values.value.size() - kHead);
  if (values.value[1] != count) return;
  double step_m = 0;
  try {
    step_m = units.quantity(*options.step_x, "m", "0.5 um");
  } catch (const io::UnitError&) {
    return;  // is reported where the step is read
  }
  const double length_m = 1e-3 * values.value[0];
  const auto is_step = [step_m](double step) { return std::abs(step / step_m - 1) <= kSameStep; };
  if (!is_step(length_m / count) && !is_step(length_m / (count - 1))) return;
  values.notes.push_back(
      fmt::format("the first two values, {:.6g} and {:.0f}, are the length in mm and the number of "
                  "the heights behind them, by the stated step, and were omitted",
                  values.value[0], values.value[1]));
  values.value.erase(values.value.begin(), values.value.begin() + kHead);
  if (!values.missing.empty()) values.missing.erase(values.missing.begin(), values.missing.begin() + kHead);
  values.channel.points_x = values.value.size();
  values.doubts = count_doubts(values.value);
}

struct Loaded {
  ChannelValues values;  ///< heights in metres
  SurfaceOrigin origin;
  HeightUnit unit;  ///< unit of the heights in the file
  std::vector<Doubt> doubts;

  Record record() { return {origin.notes, doubts}; }
};

Loaded load(const std::string& path, const SurfaceOptions& options, const io::Units& units) {
  const InstrumentFile file = open_instrument_file(path, options.layout, options.table);
  Loaded loaded;
  SurfaceOrigin& origin = loaded.origin;
  origin.path = path;
  origin.format = file.format;
  origin.instrument = file.instrument;
  origin.date = file.date;
  origin.channels = file.channels;
  origin.notes = file.notes;
  const std::size_t index = chosen_channel(file, path, options, units, origin.notes);
  origin.channel = file.channels[index].name;
  origin.channel_number = index + 1;
  loaded.values = file.values(index);
  turn_column(loaded.values);
  if (is_text_format(file.format)) drop_length_and_count(loaded.values, options, units);
  origin.notes.insert(origin.notes.end(), loaded.values.notes.begin(), loaded.values.notes.end());
  loaded.doubts = loaded.values.doubts;
  Record record = loaded.record();
  const Scale scale = height_scale(path, loaded.values, options, units, record);
  loaded.unit = {options.height_unit.value_or(loaded.values.channel.unit), scale.to_si(1)};
  scale_heights(path, loaded.values, scale, options.names);
  origin.sha256 = io::file_sha256(path);
  return loaded;
}

bool is_refusal(const Doubt& doubt) { return doubt.weight == Doubt::Weight::kRefusal; }

/// Adds the doubts about the heights to those of the reading, and takes points as missing where these require it.
/// Without a refusal all of them are notes; with one the file is refused for it, with what is doubtful in the reading.
void check_heights(surface::HeightMap& map, Loaded& loaded) {
  std::vector<Doubt> doubts = loaded.doubts;
  if (std::none_of(doubts.begin(), doubts.end(), is_refusal)) {  // else the heights are not those of the file
    const std::vector<Doubt> found = height_doubts(map, loaded.unit);
    const bool is_refused = std::any_of(found.begin(), found.end(), is_refusal);
    std::copy_if(found.begin(), found.end(), std::back_inserter(doubts),
                 [is_refused](const Doubt& doubt) { return !is_refused || is_refusal(doubt); });
  }
  for (const Doubt& doubt : doubts) {
    loaded.origin.doubts.push_back(doubt.message + "; " + doubt.remedy);
    if (doubt.weight == Doubt::Weight::kMissing) set_missing(map, doubt.points);
  }
  if (std::none_of(doubts.begin(), doubts.end(), is_refusal)) return;
  std::vector<Fault> faults;
  for (const Doubt& doubt : doubts) faults.push_back({{loaded.origin.path, 0, 0, ""}, doubt.message, doubt.remedy});
  throw InputError(faults);
}

std::string shown_length(double length_m) {
  const double size = std::abs(length_m);
  const bool is_tiny = size != 0 && size < 1e-7;
  return text_in(length_m, size >= 1e-3 ? kMillimetre : is_tiny ? kNanometre : kMicrometre, 5);
}

}  // namespace

InstrumentFile open_instrument_file(const std::string& path, TableLayout layout, const io::TableReading& stated) {
  auto bytes = std::make_shared<const std::string>(file_bytes(path, kMaxInstrumentFile));
  if (std::optional<Fault> fault = io::foreign_file_fault({path, 0, 0, ""}, *bytes)) {
    throw InputError(std::vector<Fault>{std::move(*fault)});
  }
  if (starts_with(*bytes, "PK\x03\x04")) {
    bytes.reset();
    return is_x3p(path) ? read_x3p(path) : through_gwyddion(path);
  }
  if (io::has_digest_trailer(*bytes)) {
    refuse(path, "this is a result that ringfilm wrote, not a measured surface", "name the file of the instrument");
  }
  if (is_sdf(*bytes)) return read_sdf(path, bytes);
  if (starts_with(*bytes, "DIGITAL SURF") || starts_with(*bytes, "DSCOMPRESSED")) return read_digital_surf(path, bytes);
  if (starts_with(*bytes, "Gwyddion Simple Field 1.0")) return read_simple_field(path, bytes);
  if (starts_with(*bytes, "GWYP")) return read_gwy(path, bytes);
  if (is_smd(*bytes)) return read_smd(path, *bytes);
  std::vector<std::string> notes;
  if (std::optional<io::DecodedText> text = io::decoded(*bytes)) {
    bytes = std::make_shared<const std::string>(std::move(text->text));
    notes.push_back("the file is " + text->encoding + " text and was read so");
  }
  const TextHead head = text_head(*bytes, stated);
  const auto noted = [&notes](InstrumentFile file) {
    file.notes.insert(file.notes.begin(), notes.begin(), notes.end());
    return file;
  };
  if (head.kind != TextKind::kNone && !stated.columns && !stated.skip_lines) {
    if (std::optional<InstrumentFile> file = read_trade_table(path, *bytes)) return noted(std::move(*file));
  }
  if (layout != TableLayout::kByContent || head.kind == TextKind::kTable) {
    return noted(read_height_table(path, *bytes, layout, stated));
  }
  bytes.reset();
  return head.kind == TextKind::kOther ? text_through_gwyddion(path, head) : through_gwyddion(path);
}

SurfaceFile read_surface_file(const std::string& path, const SurfaceOptions& options, const io::Units& units) {
  Loaded loaded = load(path, options, units);
  ChannelValues& values = loaded.values;
  Record record = loaded.record();
  set_step_of_places(values, options, record);
  if (!values.x.empty() && values.step_x == 0 && !options.step_x && is_text_format(loaded.origin.format)) {
    const std::size_t n_notes = values.notes.size();
    resample_evenly(values);
    // The heights are in metres by now.
    loaded.origin.notes.insert(loaded.origin.notes.end(), values.notes.begin() + static_cast<std::ptrdiff_t>(n_notes),
                               values.notes.end());
  } else if (!values.x.empty() && values.step_x == 0 && !options.step_x) {
    refuse(path, "the places of the profile are not even, and a map requires even steps",
           "resample it in the program that wrote it");
  }
  const Steps steps = steps_of(path, values, options, units, record);
  SurfaceFile result;
  surface::HeightMap& map = result.map;
  map.points_x = values.channel.points_x;
  map.points_y = values.channel.points_y;
  map.step_x_m = steps.x_m;
  map.step_y_m = map.is_profile() ? 0.0 : steps.y_m;
  map.height_m = std::move(values.value);
  map.missing = std::move(values.missing);
  for (std::size_t i = 0; i < map.missing.size(); ++i) {
    if (map.missing[i] != 0) map.height_m[i] = 0;
  }
  check_heights(map, loaded);
  result.plausibility_line = plausibility_line(map);
  result.origin = std::move(loaded.origin);
  return result;
}

TraceFile read_trace_file(const std::string& path, const SurfaceOptions& options, const io::Units& units) {
  Loaded loaded = load(path, options, units);
  ChannelValues& values = loaded.values;
  if (values.channel.points_y != 1) {
    refuse(path, fmt::format("a profile is required, and the file has {} rows", values.channel.points_y),
           "export one profile from it");
  }
  TraceFile result;
  Scale scale;
  double step_m = 0;
  Record record = loaded.record();
  set_step_of_places(values, options, record);
  if (values.x.empty() || options.step_x) {
    step_m = steps_of(path, values, options, units, record).x_m;
  } else {
    scale = lateral_scale(path, values, options, units, record);
  }
  const auto place_m = [&](std::size_t i) {
    return step_m > 0 ? step_m * static_cast<double>(i) : scale.to_si(values.x[i]);
  };
  std::vector<std::size_t> measured;
  for (std::size_t i = 0; i < values.value.size(); ++i) {
    if (!values.is_missing(i)) measured.push_back(i);
  }
  if (measured.size() < 2) refuse(path, "the profile has one measured point", "two or more are required");
  surface::HeightMap map;
  map.points_x = values.channel.points_x;
  map.points_y = 1;
  map.step_x_m = (place_m(measured.back()) - place_m(measured.front())) / static_cast<double>(values.value.size() - 1);
  map.height_m = std::move(values.value);
  map.missing = std::move(values.missing);
  check_heights(map, loaded);
  result.plausibility_line = plausibility_line(map);
  for (const std::size_t i : measured) {
    if (!map.measured(i)) continue;
    result.trace.x_m.push_back(place_m(i));
    result.trace.height_m.push_back(map.height_m[i]);
  }
  result.origin = std::move(loaded.origin);
  return result;
}

std::vector<ChannelValues> read_channels(const std::string& path) {
  const InstrumentFile file = open_instrument_file(path);
  std::vector<ChannelValues> channels;
  for (std::size_t i = 0; i < file.channels.size(); ++i) channels.push_back(file.values(i));
  return channels;
}

ChannelFound find_channel(const std::vector<Channel>& channels, const std::string& requested) {
  ChannelFound found;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    if (channels[i].name == requested && ++found.n_named == 1) found.index = i;
  }
  if (found.n_named == 1) return found;
  const std::size_t number = number_from<std::size_t>(requested).value_or(0);
  found.index.reset();
  if (number >= 1 && number <= channels.size()) found.index = number - 1;
  return found;
}

std::string channel_list(const std::vector<Channel>& channels) {
  std::string list;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const Channel& channel = channels[i];
    list += fmt::format("{}    {}: {} [{}], {} x {} points", i == 0 ? "" : "\n", i + 1,
                        channel.name.empty() ? "(no name)" : channel.name,
                        channel.unit.empty() ? "unit not stated" : channel.unit, channel.points_x, channel.points_y);
  }
  return list;
}

std::string plausibility_line(const surface::HeightMap& map) {
  double sum = 0, lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  std::size_t measured = 0;
  for (std::size_t i = 0; i < map.points(); ++i) {
    if (!map.measured(i)) continue;
    ++measured;
    sum += map.height_m[i];
    lowest = std::min(lowest, map.height_m[i]);
    highest = std::max(highest, map.height_m[i]);
  }
  if (measured == 0) return fmt::format("{} x {} points, none measured", map.points_x, map.points_y);
  const double mean = sum / static_cast<double>(measured);
  double squares = 0;
  for (std::size_t i = 0; i < map.points(); ++i) {
    if (map.measured(i)) squares += (map.height_m[i] - mean) * (map.height_m[i] - mean);
  }
  const double missing = 100 * (1 - static_cast<double>(measured) / static_cast<double>(map.points()));
  const bool is_profile = map.is_profile();
  std::string line = is_profile ? fmt::format("{} points, {}, step {}", map.points_x,
                                              shown_length(map.step_x_m * static_cast<double>(map.points_x)),
                                              shown_length(map.step_x_m))
                                : fmt::format("{} x {} points, {} x {}, step {} x {}", map.points_x, map.points_y,
                                              shown_length(map.step_x_m * static_cast<double>(map.points_x)),
                                              shown_length(map.step_y_m * static_cast<double>(map.points_y)),
                                              shown_length(map.step_x_m), shown_length(map.step_y_m));
  return line + fmt::format("; {} {} about the mean as read, min {}, max {}; {:.3g} % missing",
                            is_profile ? "Rq" : "Sq", shown_length(std::sqrt(squares / static_cast<double>(measured))),
                            shown_length(lowest), shown_length(highest), missing);
}

}  // namespace ringfilm::instrument
