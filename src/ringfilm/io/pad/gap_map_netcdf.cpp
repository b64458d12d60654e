#include <fmt/format.h>
#include <netcdf.h>
#include <netcdf_mem.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string_view>

#include "ringfilm/io/pad/gap_map_file.hpp"
#include "ringfilm/io/result/result_file_netcdf.hpp"
#include "ringfilm/io/storage/digest.hpp"

namespace ringfilm::io {
namespace {

constexpr std::size_t kMaxMap = std::size_t{256} << 20;  // [byte]
constexpr const char* kExpected = "a variable h(y, x) is required, with coordinates x(x) and y(y), each with units";

[[noreturn]] void refuse(const std::string& shown, const std::string& what, const std::string& remedy) {
  throw InputError(std::vector<Fault>{{{shown, 0, 0, ""}, what, remedy}});
}

/// CDF-1, CDF-2 and CDF-5 of the format specification.
bool is_classic(std::string_view start) { return start.substr(0, 3) == "CDF"; }

/// `gap.nc` becomes `gap-nc4.nc`.
std::string converted_name(const std::string& name) {
  const std::filesystem::path path(name);
  return (path.parent_path() / (path.stem().string() + "-nc4" + path.extension().string())).string();
}

/// The value that NetCDF leaves where nothing is written. Empty for types of one byte, whose every value may be meant,
/// and for those that are not numbers.
std::optional<double> default_fill(nc_type type) {
  switch (type) {
    case NC_SHORT:
      return NC_FILL_SHORT;
    case NC_USHORT:
      return NC_FILL_USHORT;
    case NC_INT:
      return NC_FILL_INT;
    case NC_UINT:
      return NC_FILL_UINT;
    case NC_INT64:
      return static_cast<double>(NC_FILL_INT64);
    case NC_UINT64:
      return static_cast<double>(NC_FILL_UINT64);
    case NC_FLOAT:
      return static_cast<double>(NC_FILL_FLOAT);
    case NC_DOUBLE:
      return NC_FILL_DOUBLE;
    default:
      return std::nullopt;
  }
}

/// A variable of the file.
struct Variable {
  std::string name;
  int id = 0;
  std::vector<int> dimensions;       ///< numbers of its dimensions in the file
  std::vector<std::size_t> lengths;  ///< length of each dimension
};

/// Reads the map of a NetCDF-4 file.
class MapReader {
 public:
  MapReader(const std::string& shown, const std::string& bytes, const Units& units) : shown_(shown), units_(units) {
    // The library promises not to write into memory that is opened NC_NOWRITE.
    check(nc_open_mem("gap", NC_NOWRITE, bytes.size(), const_cast<char*>(bytes.data()), &file_), "the file");
  }
  MapReader(const MapReader&) = delete;
  MapReader& operator=(const MapReader&) = delete;
  ~MapReader() {
    if (file_ >= 0) nc_close(file_);
  }

  GapMap read() const {
    const std::string name = !contains("h") && contains("height") ? "height" : "h";
    const Variable h = required_variable(name), x = required_variable("x"), y = required_variable("y");
    if (x.dimensions.size() != 1 || y.dimensions.size() != 1 || x.dimensions == y.dimensions) {
      refuse(shown_, "x and y are not two axes", kExpected);
    }
    if (h.dimensions != std::vector<int>{y.dimensions[0], x.dimensions[0]}) {
      refuse(shown_, name + " does not run over (y, x)", "store it with a row of all x for each y");
    }
    check_length(x);
    check_length(y);
    return {values(x), values(y), values(h)};
  }

 private:
  void check(int status, const std::string& what) const {
    if (status == NC_NOERR) return;
    refuse(shown_, "cannot be read as NetCDF: " + what + ": " + nc_strerror(status),
           "the file may be damaged or cut off");
  }

  bool contains(const std::string& name) const {
    int id = 0;
    return nc_inq_varid(file_, name.c_str(), &id) == NC_NOERR;
  }

  Variable required_variable(const std::string& name) const {
    Variable variable{name, 0, {}, {}};
    if (nc_inq_varid(file_, name.c_str(), &variable.id) != NC_NOERR) {
      refuse(shown_, "the file has no variable " + name, kExpected);
    }
    int n = 0;
    check(nc_inq_varndims(file_, variable.id, &n), name);
    variable.dimensions.resize(static_cast<std::size_t>(n));
    check(nc_inq_vardimid(file_, variable.id, variable.dimensions.data()), name);
    for (const int dimension : variable.dimensions) {
      check(nc_inq_dimlen(file_, dimension, &variable.lengths.emplace_back()), name);
    }
    return variable;
  }

  void check_length(const Variable& axis) const {
    const std::size_t n = axis.lengths[0];
    if (n < 2) {
      refuse(shown_, fmt::format("the map has {} places along {}", n, axis.name),
             "two or more are required, of a fixed number");
    }
    if (n > kMaxGapPlaces) {
      refuse(shown_, fmt::format("the map has {} places along {}", n, axis.name),
             fmt::format("at the most {} are read; thin it out", kMaxGapPlaces));
    }
  }

  /// In metres; a value that the file marks as missing is a NaN.
  std::vector<double> values(const Variable& variable) const {
    const std::string called = "the variable " + variable.name + " ";
    for (const char* packed : {"scale_factor", "add_offset"}) {
      if (nc_inq_att(file_, variable.id, packed, nullptr, nullptr) != NC_NOERR) continue;
      refuse(shown_, called + "is packed with " + packed, "store the values themselves");
    }
    const std::string unit = units_of(variable);
    if (unit.empty()) refuse(shown_, called + "has no units", "give it the attribute units, for example \"mm\"");
    std::size_t n = 1;
    for (const std::size_t length : variable.lengths) n *= length;
    std::vector<double> all(n);
    check(nc_get_var_double(file_, variable.id, all.data()), variable.name);
    for (const double hole : missing(variable)) std::replace(all.begin(), all.end(), hole, std::nan(""));
    try {
      const Scale scale = units_.scale(unit, "m");
      for (double& value : all) value = scale.to_si(value);
    } catch (const UnitError& problem) {
      refuse(shown_, called + problem.what(), problem.remedy.empty() ? "for example \"mm\"" : problem.remedy);
    }
    return all;
  }

  /// The values that mark a hole.
  std::vector<double> missing(const Variable& variable) const {
    std::vector<double> marks;
    const auto add = [&](const char* attribute) {
      std::size_t size = 0;
      double mark = 0;
      const bool is_number = nc_inq_attlen(file_, variable.id, attribute, &size) == NC_NOERR && size == 1 &&
                             nc_get_att_double(file_, variable.id, attribute, &mark) == NC_NOERR;
      if (is_number) marks.push_back(mark);
      return is_number;
    };
    add("missing_value");
    if (add("_FillValue")) return marks;
    nc_type type = 0;
    check(nc_inq_vartype(file_, variable.id, &type), variable.name);
    if (const auto fill = default_fill(type)) marks.push_back(*fill);
    return marks;
  }

  /// Empty if the variable has none.
  std::string units_of(const Variable& variable) const {
    nc_type type = 0;
    std::size_t size = 0;
    constexpr std::size_t kMax = 100;
    const int status = nc_inq_att(file_, variable.id, "units", &type, &size);
    if (status == NC_NOERR && type == NC_STRING && size == 1) return string_of(variable);
    if (status != NC_NOERR || type != NC_CHAR || size == 0 || size > kMax) return "";
    std::string text(size, '\0');
    check(nc_get_att_text(file_, variable.id, "units", text.data()), variable.name);
    return text.substr(0, text.find('\0'));
  }

  /// An attribute that is one string of any length, as some programs write what is not ASCII.
  std::string string_of(const Variable& variable) const {
    char* stored = nullptr;
    check(nc_get_att_string(file_, variable.id, "units", &stored), variable.name);
    const std::string text = stored == nullptr ? "" : stored;
    if (stored != nullptr) nc_free_string(1, &stored);
    return text;
  }

  std::string shown_;
  const Units& units_;
  NetcdfInUse in_use_;
  int file_ = -1;
};

/// The library ends in a segmentation fault on some damaged files of the classic formats (docs/decisions/0010).
void refuse_classic(const NamedFile& file, const std::string& bytes) {
  if (!is_classic(bytes)) return;
  refuse(file.shown, "is a NetCDF file of a classic format; only NetCDF-4 is read",
         fmt::format("convert it: nccopy -k nc4 {0} {1}", file.shown, converted_name(file.shown)));
}

/// The index of the first value that is missing.
std::optional<std::size_t> hole(const std::vector<double>& values) {
  const auto found = std::find_if(values.begin(), values.end(), [](double value) { return !std::isfinite(value); });
  return found == values.end() ? std::nullopt : std::optional<std::size_t>(found - values.begin());
}

void check_axis(const std::string& shown, const std::string& name, const std::vector<double>& places,
                std::vector<Fault>& faults) {
  const SourceMark mark{shown, 0, 0, ""};
  if (hole(places)) {
    faults.push_back({mark, name + " has a value that is missing or not finite", "give every place a number"});
    return;
  }
  const auto wrong = wrong_place(places);
  if (!wrong) return;
  const auto at = [&places](std::size_t i) { return text_in(places[i], kMillimetre); };
  const auto fault = [&](const std::string& what, const std::string& remedy) {
    faults.push_back({mark, fmt::format("{}[{}] = {} {}", name, wrong->index, at(wrong->index), what), remedy});
  };
  switch (wrong->fault) {
    case PlaceFault::kFalls:
      fault(fmt::format("lies below {}[{}] = {}", name, wrong->index - 1, at(wrong->index - 1)),
            fmt::format("store {} so that it rises, and h in the same order", name));
      return;
    case PlaceFault::kThreeTimes:
      fault("comes three times", fmt::format("the same {} twice is a step; keep two of them", name));
      return;
    case PlaceFault::kStepAtEnd:
      fault("is a step at an end of the pad", "a step is required inside, with a gap on both sides");
      return;
  }
}

}  // namespace

bool is_netcdf(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  std::array<char, 8> head{};
  std::ifstream(path, std::ios::binary).read(head.data(), head.size());
  const std::string_view start(head.data(), head.size());
  return start == "\x89HDF\r\n\x1a\n" || is_classic(start);
}

GapMapFile read_gap_netcdf(const NamedFile& file, const Units& units) {
  const std::string bytes = read_source_bytes(file.path, file.shown, kMaxMap);
  refuse_classic(file, bytes);
  GapMapFile read{MapReader(file.shown, bytes, units).read(), sha256(bytes)};
  const GapMap& map = read.map;
  std::vector<Fault> faults;
  check_axis(file.shown, "x", map.x, faults);
  check_axis(file.shown, "y", map.y, faults);
  const auto at = [&map](std::size_t k) {
    return "at x = " + text_in(map.x[k % map.x.size()], kMillimetre) +
           ", y = " + text_in(map.y[k / map.x.size()], kMillimetre);
  };
  const SourceMark mark{file.shown, 0, 0, ""};
  if (const auto k = hole(map.height); k && faults.empty()) {
    faults.push_back({mark, fmt::format("the map has a hole {}: the value is missing or not finite", at(*k)),
                      "give every point a height"});
  } else if (const auto thick = implausible_height(map.height); thick && faults.empty()) {
    faults.push_back({mark, at(*thick) + ": " + implausible_height_text(map.height[*thick]), kImplausibleHeightRemedy});
  }
  if (!faults.empty()) throw InputError(faults);
  return read;
}

}  // namespace ringfilm::io
