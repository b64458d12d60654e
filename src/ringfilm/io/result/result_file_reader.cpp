#include "ringfilm/io/result/result_file_reader.hpp"

#include <netcdf.h>
#include <netcdf_mem.h>

#include "ringfilm/base/error.hpp"
#include "ringfilm/io/result/netcdf_type.hpp"
#include "ringfilm/io/result/result_file_quantities.hpp"

namespace ringfilm::io {
namespace {

/// No result of ours is near it; a damaged length must not ask for the memory of the machine.
constexpr std::size_t kMaxValues = std::size_t{1} << 28;

}  // namespace

ResultFileReader::ResultFileReader(const std::string& path, std::string_view bytes) : path_(path) {
  // The library promises not to write into memory that is opened NC_NOWRITE.
  check(nc_open_mem("ringfilm", NC_NOWRITE, bytes.size(), const_cast<char*>(bytes.data()), &file_), "the file");
}

ResultFileReader::~ResultFileReader() {
  if (file_ >= 0) nc_close(file_);
}

void ResultFileReader::refuse(const std::string& what) const {
  throw InputError(path_ + ": cannot be read as a result: " + what,
                   "the file is damaged, cut off or from another version; run its case again");
}

void ResultFileReader::check(int status, const std::string& what) const {
  if (status != NC_NOERR) refuse(what + ": " + nc_strerror(status));
}

bool ResultFileReader::has_attribute(const char* name) const {
  return nc_inq_att(file_, NC_GLOBAL, name, nullptr, nullptr) == NC_NOERR;
}

bool ResultFileReader::has_variable(const std::string& name) const {
  int variable = 0;
  return nc_inq_varid(file_, name.c_str(), &variable) == NC_NOERR;
}

void ResultFileReader::attribute(const char* name, std::string& text) const {
  if (ring_ && std::string(name) == "title") return scalar(described("ring_title", "", ""), text);
  nc_type type = 0;
  std::size_t size = 0;
  check(nc_inq_att(file_, NC_GLOBAL, name, &type, &size), name);
  if (type != NC_CHAR || size > kMaxValues) refuse(std::string(name) + " is not text");
  text.assign(size, '\0');
  if (size > 0) check(nc_get_att_text(file_, NC_GLOBAL, name, text.data()), name);
}

void ResultFileReader::check_single(const char* name) const {
  std::size_t size = 0;
  check(nc_inq_attlen(file_, NC_GLOBAL, name, &size), name);
  if (size != 1) refuse(std::string(name) + " is not a single number");
}

void ResultFileReader::attribute(const char* name, double& value) const {
  if (ring_) return read_one(described(name, "", ""), value);
  check_single(name);
  check(nc_get_att_double(file_, NC_GLOBAL, name, &value), name);
}

void ResultFileReader::attribute(const char* name, long& value) const {
  if (ring_) return read_one(described(name, "", ""), value);
  check_single(name);
  check(nc_get_att_long(file_, NC_GLOBAL, name, &value), name);
}

void ResultFileReader::attribute(const char* name, bool& value) const {
  if (ring_) {
    signed char stored = 0;
    read_one(described(name, "", ""), stored);
    value = stored != 0;
    return;
  }
  long number = 0;
  attribute(name, number);
  value = number != 0;
}

std::size_t ResultFileReader::length_in_file(const char* dimension) const {
  int number = 0;
  std::size_t size = 0;
  if (nc_inq_dimid(file_, dimension, &number) != NC_NOERR) return 0;
  check(nc_inq_dimlen(file_, number, &size), dimension);
  if (size > kMaxValues) refuse(std::string(dimension) + " has an impossible length");
  return size;
}

template <class Value>
void ResultFileReader::get(int variable, const std::string& name, std::vector<Value>& values) const {
  if constexpr (std::is_same_v<Value, std::string>) {
    std::vector<char*> texts(values.size(), nullptr);
    check(nc_get_var(file_, variable, texts.data()), name);
    for (std::size_t i = 0; i < texts.size(); ++i) {
      if (texts[i] != nullptr) values[i] = texts[i];
    }
    nc_free_string(texts.size(), texts.data());
  } else {
    check(nc_get_var(file_, variable, values.data()), name);
  }
}

std::size_t ResultFileReader::length(const char* dimension) const {
  const std::size_t in_file = length_in_file(dimension);
  if (!ring_ || in_file == 0) return in_file;
  const std::string name = std::string("n_") + dimension;
  std::size_t n_rings = 0;
  const auto variable = find({"ring"}, name, NC_INT64, n_rings);
  std::vector<long> lengths(n_rings);
  if (variable) get(*variable, name, lengths);
  const long own = lengths.at(*ring_);
  if (own < 0 || static_cast<std::size_t>(own) > in_file) refuse(name + " has an impossible length");
  return static_cast<std::size_t>(own);
}

std::optional<int> ResultFileReader::find(const std::vector<const char*>& dimensions, const std::string& name, int type,
                                          std::size_t& count) const {
  count = 1;
  for (const char* dimension : dimensions) {
    count *= length_in_file(dimension);
    if (count > kMaxValues) refuse(name + " has an impossible size");
  }
  if (count == 0) return std::nullopt;
  int variable = 0;
  check(nc_inq_varid(file_, name.c_str(), &variable), "variable " + name);
  nc_type stored_type = 0;
  int n_dimensions = 0;
  check(nc_inq_var(file_, variable, nullptr, &stored_type, &n_dimensions, nullptr, nullptr), name);
  if (stored_type != type) refuse("variable " + name + " has another type");
  std::vector<int> numbers(static_cast<std::size_t>(n_dimensions));
  check(nc_inq_vardimid(file_, variable, numbers.data()), name);
  std::size_t stored = 1;
  for (const int number : numbers) {
    std::size_t size = 0;
    check(nc_inq_dimlen(file_, number, &size), name);
    stored *= size;
  }
  if (stored != count || numbers.size() != dimensions.size()) refuse("variable " + name + " has another shape");
  return variable;
}

template <class Value>
void ResultFileReader::read(const std::vector<const char*>& dimensions, const cycle::Quantity& quantity,
                            std::vector<Value>& values) const {
  std::vector<const char*> in_file = dimensions;
  std::string name = quantity.name;
  // A coordinate that all rings share has no ring (RingGatherer).
  const bool is_coordinate = dimensions.size() == 1 && name == dimensions.front();
  const bool is_shared = ring_ && is_coordinate && has_variable(name);
  if (ring_ && is_coordinate && !is_shared) name += "_of_ring";
  if (ring_ && !is_shared) in_file.insert(in_file.begin(), "ring");
  std::size_t count = 0;
  const auto variable = find(in_file, name, kNetcdfType<Value>, count);
  values.assign(count, Value{});
  if (variable) get(*variable, name, values);
  if (is_shared) values.resize(length(dimensions.front()));
  if (!ring_ || is_shared || !variable) return;
  std::vector<std::size_t> lengths, shape;
  std::size_t n = 1;
  for (const char* dimension : dimensions) {
    n *= lengths.emplace_back(length(dimension));
    shape.push_back(length_in_file(dimension));
  }
  const std::size_t of_one = count / n_rings();
  std::vector<Value> own;
  for (std::size_t i = 0; i < n; ++i) own.push_back(std::move(values[*ring_ * of_one + place_in(i, lengths, shape)]));
  values = std::move(own);
}

template void ResultFileReader::read(const std::vector<const char*>&, const cycle::Quantity&,
                                     std::vector<double>&) const;
template void ResultFileReader::read(const std::vector<const char*>&, const cycle::Quantity&,
                                     std::vector<float>&) const;
template void ResultFileReader::read(const std::vector<const char*>&, const cycle::Quantity&, std::vector<long>&) const;
template void ResultFileReader::read(const std::vector<const char*>&, const cycle::Quantity&,
                                     std::vector<signed char>&) const;
template void ResultFileReader::read(const std::vector<const char*>&, const cycle::Quantity&,
                                     std::vector<std::string>&) const;

template <class Value>
void ResultFileReader::read_one(const cycle::Quantity& quantity, Value& value) const {
  std::vector<Value> one;
  read({}, quantity, one);
  value = one.front();
}

void ResultFileReader::scalar(const cycle::Quantity& quantity, double& value) const { read_one(quantity, value); }

void ResultFileReader::scalar(const cycle::Quantity& quantity, std::string& text) const { read_one(quantity, text); }

void ResultFileReader::scalars(const std::string& prefix, std::map<std::string, double>& values) const {
  int n_variables = 0;
  check(nc_inq_nvars(file_, &n_variables), "the list of variables");
  for (int variable = 0; variable < n_variables; ++variable) {
    char name[NC_MAX_NAME + 1] = {};
    check(nc_inq_varname(file_, variable, name), "the list of variables");
    if (std::string(name).compare(0, prefix.size(), prefix) != 0) continue;
    cycle::Quantity quantity;
    quantity.name = name;
    scalar(quantity, values[name + prefix.size()]);
  }
}

}  // namespace ringfilm::io
