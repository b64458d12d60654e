#include <fmt/format.h>
#include <netcdf.h>
#include <netcdf_mem.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>

#include "ringfilm/io/pad/gap_map_file.hpp"
#include "ringfilm/io/result/result_file_netcdf.hpp"
#include "ringfilm/io/storage/classic_netcdf.hpp"
#include "ringfilm/io/storage/digest.hpp"

namespace ringfilm::io {
namespace {

constexpr std::size_t kLargestMap = std::size_t{256} << 20;  // [byte]
constexpr const char* kExpected = "a variable h(y, x) is required, with coordinates x(x) and y(y), each with units";

[[noreturn]] void refuse(const std::string& shown, const std::string& what, const std::string& remedy) {
  throw InputError(std::vector<Fault>{{{shown, 0, 0, ""}, what, remedy}});
}

[[noreturn]] void refuse_damaged(const std::string& shown, const std::string& what) {
  refuse(shown, "cannot be read as NetCDF: " + what, "the file may be damaged or cut off");
}

/// A file of NetCDF-4, open as long as this lives.
class OpenFile {
 public:
  OpenFile(const std::string& shown, const std::string& bytes) : shown_(shown) {
    // The library promises not to write into memory that is opened NC_NOWRITE.
    check(nc_open_mem("gap", NC_NOWRITE, bytes.size(), const_cast<char*>(bytes.data()), &file_), "the file");
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  ~OpenFile() {
    if (file_ >= 0) nc_close(file_);
  }

  std::optional<StoredVariable> find(const std::string& name) const {
    int variable = 0, n = 0;
    if (nc_inq_varid(file_, name.c_str(), &variable) != NC_NOERR) return std::nullopt;
    check(nc_inq_varndims(file_, variable, &n), name);
    StoredVariable found;
    found.dimensions.resize(static_cast<std::size_t>(n));
    check(nc_inq_vardimid(file_, variable, found.dimensions.data()), name);
    std::size_t all = 1;
    for (const int dimension : found.dimensions) {
      std::size_t length = 0;
      check(nc_inq_dimlen(file_, dimension, &length), name);
      found.lengths.push_back(length);
      all *= length;
    }
    found.units = units_of(variable, name);
    for (const char* packed : {"scale_factor", "add_offset"}) {
      if (nc_inq_att(file_, variable, packed, nullptr, nullptr) == NC_NOERR) found.packed_by = packed;
    }
    for (const char* mark : {"_FillValue", "missing_value"}) {
      std::size_t size = 0;
      double missing = 0;
      if (nc_inq_attlen(file_, variable, mark, &size) == NC_NOERR && size == 1 &&
          nc_get_att_double(file_, variable, mark, &missing) == NC_NOERR) {
        found.missing.push_back(missing);
        found.has_fill = found.has_fill || mark == std::string_view("_FillValue");
      }
    }
    nc_type type = 0;
    check(nc_inq_vartype(file_, variable, &type), name);
    found.add_default_fill(type);
    found.values = [this, variable, name, all] {
      std::vector<double> values(all);
      check(nc_get_var_double(file_, variable, values.data()), name);
      return values;
    };
    return found;
  }

 private:
  void check(int status, const std::string& what) const {
    if (status != NC_NOERR) refuse_damaged(shown_, what + ": " + nc_strerror(status));
  }

  /// Empty for none.
  std::string units_of(int variable, const std::string& name) const {
    nc_type type = 0;
    std::size_t size = 0;
    constexpr std::size_t kLongest = 100;
    const int status = nc_inq_att(file_, variable, "units", &type, &size);
    if (status == NC_NOERR && type == NC_STRING && size == 1) return string_of(variable, name);
    if (status != NC_NOERR || type != NC_CHAR || size == 0 || size > kLongest) return "";
    std::string text(size, '\0');
    check(nc_get_att_text(file_, variable, "units", text.data()), name);
    return text.substr(0, text.find('\0'));
  }

  /// An attribute that is one string of any length, as some programs write what is not ASCII.
  std::string string_of(int variable, const std::string& name) const {
    char* stored = nullptr;
    check(nc_get_att_string(file_, variable, "units", &stored), name);
    const std::string text = stored == nullptr ? "" : stored;
    if (stored != nullptr) nc_free_string(1, &stored);
    return text;
  }

  std::string shown_;
  NetcdfInUse in_use_;
  int file_ = -1;
};

using Find = std::function<std::optional<StoredVariable>(const std::string& name)>;

/// The map of a file, whatever reads it.
class MapReader {
 public:
  MapReader(const std::string& shown, const Find& find, const Units& units)
      : shown_(shown), find_(find), units_(units) {}

  GapMap read() const {
    const std::string name = !find_("h") && find_("height") ? "height" : "h";
    const StoredVariable h = variable(name), x = variable("x"), y = variable("y");
    if (x.dimensions.size() != 1 || y.dimensions.size() != 1 || x.dimensions == y.dimensions) {
      refuse(shown_, "x and y are not two axes", kExpected);
    }
    if (h.dimensions != std::vector<int>{y.dimensions[0], x.dimensions[0]}) {
      refuse(shown_, name + " does not run over (y, x)", "store it with a row of all x for each y");
    }
    check_length(x.lengths[0], "x");
    check_length(y.lengths[0], "y");
    return {values(x, "x"), values(y, "y"), values(h, name)};
  }

 private:
  StoredVariable variable(const std::string& name) const {
    auto variable = find_(name);
    if (!variable) refuse(shown_, "the file has no variable " + name, kExpected);
    return std::move(*variable);
  }

  void check_length(std::size_t n, const std::string& name) const {
    if (n < 2) {
      refuse(shown_, "the map has " + std::to_string(n) + " places along " + name,
             "two or more are required, of a fixed number");
    }
    if (n > kMostGapPlaces) {
      refuse(shown_, fmt::format("the map has {} places along {}", n, name),
             fmt::format("at the most {} are read; thin it out", kMostGapPlaces));
    }
  }

  /// In metres; a value that the file marks as missing is a NaN.
  std::vector<double> values(const StoredVariable& variable, const std::string& name) const {
    if (!variable.packed_by.empty()) {
      refuse(shown_, "the variable " + name + " is packed with " + variable.packed_by, "store the values themselves");
    }
    if (variable.units.empty()) {
      refuse(shown_, "the variable " + name + " has no units", "give it the attribute units, for example \"mm\"");
    }
    std::vector<double> all = variable.values();
    for (const double missing : variable.missing) {
      for (double& value : all) value = value == missing ? std::nan("") : value;
    }
    try {
      const Scale scale = units_.scale(variable.units, "m");
      for (double& value : all) value = scale.to_si(value);
    } catch (const UnitError& problem) {
      refuse(shown_, "the variable " + name + " " + problem.what(),
             problem.remedy.empty() ? "for example \"mm\"" : problem.remedy);
    }
    return all;
  }

  std::string shown_;
  const Find& find_;
  const Units& units_;
};

GapMap map_of(const std::string& shown, const std::string& bytes, const Units& units) {
  if (bytes.rfind("CDF", 0) != 0) {
    const OpenFile file(shown, bytes);
    const Find find = [&file](const std::string& name) { return file.find(name); };
    return MapReader(shown, find, units).read();
  }
  try {
    const auto all = classic_netcdf_variables(bytes);
    const Find find = [&all](const std::string& name) {
      const auto found = all.find(name);
      return found == all.end() ? std::nullopt : std::optional(found->second);
    };
    return MapReader(shown, find, units).read();
  } catch (const ClassicNetcdfError& problem) {
    refuse_damaged(shown, problem.what());
  }
}

/// The index of the first value that is not a height.
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
  const auto fault = [&](const std::string& what, const std::string& remedy) {
    faults.push_back(
        {mark, fmt::format("{}[{}] = {:.6g} mm {}", name, wrong->index, 1e3 * places[wrong->index], what), remedy});
  };
  switch (wrong->fault) {
    case PlaceFault::kFalls:
      fault(fmt::format("lies below {}[{}] = {:.6g} mm", name, wrong->index - 1, 1e3 * places[wrong->index - 1]),
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
  return start == "\x89HDF\r\n\x1a\n" || start.substr(0, 3) == "CDF";
}

GapMapFile read_gap_netcdf(const NamedFile& file, const Units& units) {
  const std::string bytes = read_source_bytes(file.path, file.shown, kLargestMap);
  GapMapFile read{map_of(file.shown, bytes, units), sha256(bytes)};
  const GapMap& map = read.map;
  std::vector<Fault> faults;
  check_axis(file.shown, "x", map.x, faults);
  check_axis(file.shown, "y", map.y, faults);
  const auto at = [&map](std::size_t k) {
    return fmt::format("at x = {:.6g} mm, y = {:.6g} mm", 1e3 * map.x[k % map.x.size()], 1e3 * map.y[k / map.x.size()]);
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
