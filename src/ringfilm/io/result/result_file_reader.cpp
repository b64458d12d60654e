#include "ringfilm/io/result/result_file_reader.hpp"

#include <netcdf.h>
#include <netcdf_mem.h>

#include "ringfilm/base/error.hpp"

namespace ringfilm::io {
namespace {

/// No result of ours is near it; a damaged length must not ask for the memory of the machine.
constexpr std::size_t kMostValues = std::size_t{1} << 28;

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
  nc_type type = 0;
  std::size_t size = 0;
  check(nc_inq_att(file_, NC_GLOBAL, name, &type, &size), name);
  if (type != NC_CHAR || size > kMostValues) refuse(std::string(name) + " is no text");
  text.assign(size, '\0');
  if (size > 0) check(nc_get_att_text(file_, NC_GLOBAL, name, text.data()), name);
}

void ResultFileReader::attribute(const char* name, double& value) const {
  std::size_t size = 0;
  check(nc_inq_attlen(file_, NC_GLOBAL, name, &size), name);
  if (size != 1) refuse(std::string(name) + " is no single number");
  check(nc_get_att_double(file_, NC_GLOBAL, name, &value), name);
}

void ResultFileReader::attribute(const char* name, long& value) const {
  std::size_t size = 0;
  check(nc_inq_attlen(file_, NC_GLOBAL, name, &size), name);
  if (size != 1) refuse(std::string(name) + " is no single number");
  check(nc_get_att_long(file_, NC_GLOBAL, name, &value), name);
}

void ResultFileReader::attribute(const char* name, bool& value) const {
  long number = 0;
  attribute(name, number);
  value = number != 0;
}

std::size_t ResultFileReader::length(const char* dimension) const {
  int number = 0;
  std::size_t size = 0;
  if (nc_inq_dimid(file_, dimension, &number) != NC_NOERR) return 0;
  check(nc_inq_dimlen(file_, number, &size), dimension);
  if (size > kMostValues) refuse(std::string(dimension) + " has an impossible length");
  return size;
}

std::optional<int> ResultFileReader::find(const std::vector<const char*>& dimensions, const std::string& name, int type,
                                          std::size_t& count) const {
  count = 1;
  for (const char* dimension : dimensions) {
    count *= length(dimension);
    if (count > kMostValues) refuse(name + " has an impossible size");
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

void ResultFileReader::read(const std::vector<const char*>& dimensions, const cycle::Quantity& quantity,
                            std::vector<double>& values) const {
  std::size_t count = 0;
  const auto variable = find(dimensions, quantity.name, NC_DOUBLE, count);
  values.assign(count, 0.0);
  if (variable) check(nc_get_var_double(file_, *variable, values.data()), quantity.name);
}

void ResultFileReader::read(const std::vector<const char*>& dimensions, const cycle::Quantity& quantity,
                            std::vector<float>& values) const {
  std::size_t count = 0;
  const auto variable = find(dimensions, quantity.name, NC_FLOAT, count);
  values.assign(count, 0.0F);
  if (variable) check(nc_get_var_float(file_, *variable, values.data()), quantity.name);
}

void ResultFileReader::read(const std::vector<const char*>& dimensions, const cycle::Quantity& quantity,
                            std::vector<long>& values) const {
  std::size_t count = 0;
  const auto variable = find(dimensions, quantity.name, NC_INT64, count);
  values.assign(count, 0);
  if (variable) check(nc_get_var_long(file_, *variable, values.data()), quantity.name);
}

void ResultFileReader::read(const std::vector<const char*>& dimensions, const cycle::Quantity& quantity,
                            std::vector<signed char>& values) const {
  std::size_t count = 0;
  const auto variable = find(dimensions, quantity.name, NC_BYTE, count);
  values.assign(count, 0);
  if (variable) check(nc_get_var_schar(file_, *variable, values.data()), quantity.name);
}

void ResultFileReader::read(const std::vector<const char*>& dimensions, const cycle::Quantity& quantity,
                            std::vector<std::string>& values) const {
  std::size_t count = 0;
  const auto variable = find(dimensions, quantity.name, NC_STRING, count);
  values.assign(count, "");
  if (!variable) return;
  std::vector<char*> texts(count, nullptr);
  check(nc_get_var_string(file_, *variable, texts.data()), quantity.name);
  for (std::size_t i = 0; i < count; ++i) {
    if (texts[i] != nullptr) values[i] = texts[i];
  }
  nc_free_string(count, texts.data());
}

void ResultFileReader::scalar(const cycle::Quantity& quantity, double& value) const {
  std::vector<double> one;
  read({}, quantity, one);
  value = one.front();
}

void ResultFileReader::scalar(const cycle::Quantity& quantity, std::string& text) const {
  std::vector<std::string> one;
  read({}, quantity, one);
  text = one.front();
}

void ResultFileReader::scalars(const std::string& prefix, const std::vector<cycle::Quantity>&,
                               std::map<std::string, double>& values) const {
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
