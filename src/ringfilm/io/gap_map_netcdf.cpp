#include <fmt/format.h>
#include <netcdf.h>
#include <netcdf_mem.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>

#include "ringfilm/io/digest.hpp"
#include "ringfilm/io/gap_map_file.hpp"
#include "ringfilm/io/result_file_netcdf.hpp"

namespace ringfilm::io {
namespace {

constexpr std::size_t kLargestMap = std::size_t{256} << 20;  // [byte]
constexpr const char* kWanted = "a variable h(y, x) is wanted, with coordinates x(x) and y(y), each with units";

/// An open file of the library. A file that is damaged is told, never trusted.
class MapReader {
 public:
  MapReader(const std::string& shown, const std::string& bytes, const Units& units)
      : shown_(shown), units_(units), lock_(netcdf_in_use()) {
    // The library promises not to write into memory that is opened NC_NOWRITE.
    check(nc_open_mem("gap", NC_NOWRITE, bytes.size(), const_cast<char*>(bytes.data()), &file_), "the file");
  }
  MapReader(const MapReader&) = delete;
  MapReader& operator=(const MapReader&) = delete;
  ~MapReader() {
    if (file_ >= 0) nc_close(file_);
  }

  GapMap read() {
    const std::string name = !find("h") && find("height") ? "height" : "h";
    const int h = wanted(name);
    const std::vector<int> of_x = dimensions(wanted("x"), "x"), of_y = dimensions(wanted("y"), "y");
    if (of_x.size() != 1 || of_y.size() != 1 || of_x == of_y) refuse("x and y are no two axes", kWanted);
    const std::vector<int> of_h = dimensions(h, name);
    if (of_h != std::vector<int>{of_y[0], of_x[0]}) {
      refuse(name + " does not run over (y, x)", "store it with a row of all x for each y");
    }
    GapMap map;
    map.x = values("x", length(of_x[0], "x"));
    map.y = values("y", length(of_y[0], "y"));
    map.height = values(name, map.x.size() * map.y.size());
    return map;
  }

 private:
  [[noreturn]] void refuse(const std::string& what, const std::string& remedy) const {
    throw InputError(std::vector<Fault>{{{shown_, 0, 0, ""}, what, remedy}});
  }

  void check(int status, const std::string& what) const {
    if (status != NC_NOERR) {
      refuse("cannot be read as NetCDF: " + what + ": " + nc_strerror(status), "the file may be damaged or cut off");
    }
  }

  std::optional<int> find(const std::string& name) const {
    int variable = 0;
    return nc_inq_varid(file_, name.c_str(), &variable) == NC_NOERR ? std::optional(variable) : std::nullopt;
  }

  int wanted(const std::string& name) const {
    const auto variable = find(name);
    if (!variable) refuse("the file has no variable " + name, kWanted);
    return *variable;
  }

  std::vector<int> dimensions(int variable, const std::string& name) const {
    int n = 0;
    check(nc_inq_varndims(file_, variable, &n), name);
    std::vector<int> numbers(static_cast<std::size_t>(n));
    check(nc_inq_vardimid(file_, variable, numbers.data()), name);
    return numbers;
  }

  std::size_t length(int dimension, const std::string& name) const {
    std::size_t n = 0;
    check(nc_inq_dimlen(file_, dimension, &n), name);
    if (n < 2) refuse("the map has " + std::to_string(n) + " places along " + name, "two or more are wanted");
    if (n > kMostGapPlaces) {
      refuse(fmt::format("the map has {} places along {}", n, name),
             fmt::format("at the most {} are read; thin it out", kMostGapPlaces));
    }
    return n;
  }

  std::string units_of(int variable, const std::string& name) const {
    nc_type type = 0;
    std::size_t size = 0;
    constexpr std::size_t kLongest = 100;
    const int status = nc_inq_att(file_, variable, "units", &type, &size);
    if (status != NC_NOERR || type != NC_CHAR || size == 0 || size > kLongest) {
      refuse("the variable " + name + " has no units", "give it the attribute units, for example \"mm\"");
    }
    std::string text(size, '\0');
    check(nc_get_att_text(file_, variable, "units", text.data()), name);
    return text.substr(0, text.find('\0'));
  }

  /// In metres; a value that the file marks as missing is a NaN.
  std::vector<double> values(const std::string& name, std::size_t n) const {
    const int variable = wanted(name);
    for (const char* packed : {"scale_factor", "add_offset"}) {
      if (nc_inq_att(file_, variable, packed, nullptr, nullptr) == NC_NOERR) {
        refuse("the variable " + name + " is packed with " + packed, "store the values themselves");
      }
    }
    std::vector<double> all(n);
    check(nc_get_var_double(file_, variable, all.data()), name);
    for (const char* mark : {"_FillValue", "missing_value"}) {
      std::size_t size = 0;
      double missing = 0;
      if (nc_inq_attlen(file_, variable, mark, &size) != NC_NOERR || size != 1 ||
          nc_get_att_double(file_, variable, mark, &missing) != NC_NOERR) {
        continue;
      }
      for (double& value : all) value = value == missing ? std::nan("") : value;
    }
    try {
      const Scale scale = units_.scale(units_of(variable, name), "m");
      for (double& value : all) value = scale.to_si(value);
    } catch (const UnitError& problem) {
      refuse("the variable " + name + " " + problem.what(),
             problem.remedy.empty() ? "for example \"mm\"" : problem.remedy);
    }
    return all;
  }

  std::string shown_;
  const Units& units_;
  std::unique_lock<std::mutex> lock_;
  int file_ = -1;
};

/// The number of the first value that is none.
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
  std::vector<Fault> found;
  check_gap_places(
      name, places,
      [&](std::size_t i) {
        return SourceMark{shown, static_cast<int>(i), 0, ""};
      },
      found);
  for (const Fault& fault : found) {
    faults.push_back({mark,
                      fmt::format("{}[{}] = {:.6g} mm: {}", name, fault.mark.line,
                                  1e3 * places[static_cast<std::size_t>(fault.mark.line)], fault.message),
                      fault.remedy});
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
  GapMapFile read{MapReader(file.shown, bytes, units).read(), sha256(bytes)};
  const GapMap& map = read.map;
  std::vector<Fault> faults;
  check_axis(file.shown, "x", map.x, faults);
  check_axis(file.shown, "y", map.y, faults);
  if (const auto k = hole(map.height); k && faults.empty()) {
    faults.push_back(
        {{file.shown, 0, 0, ""},
         fmt::format("the map has a hole at x = {:.6g} mm, y = {:.6g} mm: the value is missing or not finite",
                     1e3 * map.x[*k % map.x.size()], 1e3 * map.y[*k / map.x.size()]),
         "give every point a height"});
  }
  if (!faults.empty()) throw InputError(faults);
  return read;
}

}  // namespace ringfilm::io
