#include "ringfilm/io/result/result_file_writer.hpp"

#include <netcdf.h>
#include <netcdf_mem.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "ringfilm/base/error.hpp"
#include "ringfilm/io/result/netcdf_type.hpp"
#include "ringfilm/io/storage/digest.hpp"
#include "ringfilm/io/storage/digest_trailer.hpp"

namespace ringfilm::io {
namespace {

/// Below this many values a compressed variable is larger than a plain one.
constexpr std::size_t kCompressedFrom = 1024;
/// A variable of more values is a large map of measured heights, of which 14 % can be saved in 20 times the time.
constexpr std::size_t kCompressedTo = 1 << 21;
/// Higher levels cost ten times the time for 2 % of the size.
constexpr int kDeflateLevel = 4;
/// Level for fields in single precision, which may hold ten million values each.
constexpr int kFieldDeflateLevel = 1;
/// Level for variables written block by block, which may hold a million scenarios.
constexpr int kBlockDeflateLevel = 1;

/// Bytes that the file needs, from its first block (HDF5 file format specification, II.A): the library pads what it
/// makes in memory, and a padded file would not be missed its end. All of it where that block is of no known kind.
std::size_t length_in_superblock(const unsigned char* file, std::size_t size) {
  constexpr std::size_t kAtVersion = 8, kAtEndOfVersion0 = 40, kAtEndOfVersion2 = 28;
  if (size < kAtEndOfVersion0 + 8) return size;
  const std::size_t at = file[kAtVersion] < 2 ? kAtEndOfVersion0 + (file[kAtVersion] == 1 ? 4 : 0) : kAtEndOfVersion2;
  std::size_t length = 0;
  for (std::size_t i = 8; i-- > 0;) length = length << 8 | file[at + i];
  return length > kAtEndOfVersion0 && length < size ? length : size;
}

}  // namespace

ResultFileWriter::ResultFileWriter(const std::string& path) : path_(path) {
  constexpr std::size_t kFirstSize = 1 << 16;  // grows as needed [bytes]
  int previous = 0;
  check(nc_create_mem("ringfilm", NC_NETCDF4, kFirstSize, &file_), "the file");
  check(nc_set_fill(file_, NC_NOFILL, &previous), "the file");  // every variable is written as a whole
}

ResultFileWriter::ResultFileWriter(const std::string& path, AsideFile& aside, std::uint64_t most_bytes)
    : path_(path), aside_(&aside) {
  check(nc_create(aside.path().c_str(), NC_NETCDF4 | NC_CLOBBER, &file_), "the file");
  try {
    aside.reserve(most_bytes + kDigestTrailerSize);  // not before: nc_create truncates the file, which frees its space
  } catch (...) {
    nc_abort(std::exchange(file_, -1));
    throw;
  }
}

ResultFileWriter::~ResultFileWriter() {
  if (file_ >= 0) nc_abort(file_);
}

void ResultFileWriter::check(int status, const std::string& what) const {
  if (status == NC_NOERR) return;
  fail_to_write(path_, what + ": " + nc_strerror(status));
}

void ResultFileWriter::attribute(const char* name, const std::string& text) {
  check(nc_put_att_text(file_, NC_GLOBAL, name, text.size(), text.c_str()), name);
}

void ResultFileWriter::attribute(const char* name, double value) {
  check(nc_put_att_double(file_, NC_GLOBAL, name, NC_DOUBLE, 1, &value), name);
}

void ResultFileWriter::attribute(const char* name, long value) {
  check(nc_put_att_long(file_, NC_GLOBAL, name, NC_INT64, 1, &value), name);
}

void ResultFileWriter::define_dimension(const char* name, std::size_t size) {
  if (size == 0) return;
  int dimension = 0;
  check(nc_def_dim(file_, name, size, &dimension), name);
}

std::optional<int> ResultFileWriter::define_variable(const cycle::Quantity& quantity,
                                                     const std::vector<const char*>& dimensions, int type,
                                                     Storage storage) {
  std::vector<int> numbers;
  std::vector<std::size_t> lengths;
  std::size_t count = 1;
  for (const char* name : dimensions) {
    int number = 0;
    std::size_t length = 0;
    if (nc_inq_dimid(file_, name, &number) != NC_NOERR) return std::nullopt;
    check(nc_inq_dimlen(file_, number, &length), name);
    numbers.push_back(number);
    lengths.push_back(length);
    count *= length;
  }
  int variable = 0;
  check(nc_def_var(file_, quantity.name.c_str(), type, static_cast<int>(numbers.size()), numbers.data(), &variable),
        quantity.name);
  const bool is_whole = storage == Storage::kWhole;
  if (is_whole && type == NC_DOUBLE && count >= kCompressedFrom && count <= kCompressedTo) {
    check(nc_def_var_deflate(file_, variable, 1, 1, kDeflateLevel), quantity.name);
  }
  if (is_whole && type == NC_FLOAT && count >= kCompressedFrom) {
    if (lengths.size() == 3) lengths.front() = 1;  // whoever reads one crank angle reads nothing else
    check(nc_def_var_chunking(file_, variable, NC_CHUNKED, lengths.data()), quantity.name);
    check(nc_def_var_deflate(file_, variable, 1, 1, kFieldDeflateLevel), quantity.name);
  }
  const auto describe = [&](const char* attribute, const std::string& text) {
    if (!text.empty()) check(nc_put_att_text(file_, variable, attribute, text.size(), text.c_str()), quantity.name);
  };
  describe("units", quantity.unit);
  describe("long_name", quantity.long_name);
  describe("symbol", quantity.symbol);
  describe("source_equation", quantity.equation);
  return variable;
}

template <class Value>
void ResultFileWriter::put(const cycle::Quantity& quantity, const std::vector<const char*>& dimensions,
                           const std::vector<Value>& values) {
  const auto variable = define_variable(quantity, dimensions, kNetcdfType<Value>);
  if (!variable) return;
  if constexpr (std::is_same_v<Value, std::string>) {
    std::vector<const char*> pointers;
    for (const std::string& value : values) pointers.push_back(value.c_str());
    check(nc_put_var(file_, *variable, pointers.data()), quantity.name);
  } else {
    const auto is_nan = [](Value value) { return std::isnan(static_cast<double>(value)); };
    if (std::is_same_v<Value, double> && std::any_of(values.begin(), values.end(), is_nan)) {
      const double none = std::numeric_limits<double>::quiet_NaN();
      check(nc_put_att_double(file_, *variable, "_FillValue", NC_DOUBLE, 1, &none), quantity.name);
    }
    check(nc_put_var(file_, *variable, values.data()), quantity.name);
  }
}

void ResultFileWriter::texts(const char* dimension, const cycle::Quantity& quantity,
                             const std::vector<std::string>& values) {
  int number = 0;
  if (nc_inq_dimid(file_, dimension, &number) != NC_NOERR) define_dimension(dimension, values.size());
  put(quantity, {dimension}, values);
}

template <class Value>
void ResultFileWriter::numbers(const std::vector<const char*>& dimensions, const cycle::Quantity& quantity,
                               const std::vector<Value>& values) {
  std::size_t expected = 1;
  int number = 0;
  if (dimensions.size() == 1 && nc_inq_dimid(file_, dimensions.front(), &number) != NC_NOERR) {
    define_dimension(dimensions.front(), values.size());
  }
  for (const char* name : dimensions) {
    std::size_t length = 0;
    if (nc_inq_dimid(file_, name, &number) == NC_NOERR) check(nc_inq_dimlen(file_, number, &length), name);
    expected *= length;
  }
  if (values.size() != expected) {
    throw std::logic_error(quantity.name + " has " + std::to_string(values.size()) + " values on a grid of " +
                           std::to_string(expected));
  }
  put(quantity, dimensions, values);
}

template void ResultFileWriter::put(const cycle::Quantity&, const std::vector<const char*>&,
                                    const std::vector<double>&);
template void ResultFileWriter::put(const cycle::Quantity&, const std::vector<const char*>&, const std::vector<float>&);
template void ResultFileWriter::put(const cycle::Quantity&, const std::vector<const char*>&, const std::vector<long>&);
template void ResultFileWriter::put(const cycle::Quantity&, const std::vector<const char*>&,
                                    const std::vector<signed char>&);
template void ResultFileWriter::put(const cycle::Quantity&, const std::vector<const char*>&,
                                    const std::vector<std::string>&);
template void ResultFileWriter::numbers(const std::vector<const char*>&, const cycle::Quantity&,
                                        const std::vector<double>&);
template void ResultFileWriter::numbers(const std::vector<const char*>&, const cycle::Quantity&,
                                        const std::vector<float>&);

void ResultFileWriter::describe(const std::string& variable, const char* attribute, const std::string& text) {
  int number = 0;
  if (nc_inq_varid(file_, variable.c_str(), &number) != NC_NOERR) return;
  check(nc_put_att_text(file_, number, attribute, text.size(), text.c_str()), variable);
}

void ResultFileWriter::describe(const std::string& variable, const char* attribute, double value) {
  int number = 0;
  if (nc_inq_varid(file_, variable.c_str(), &number) != NC_NOERR) return;
  check(nc_put_att_double(file_, number, attribute, NC_DOUBLE, 1, &value), variable);
}

std::optional<int> ResultFileWriter::blocks(const std::vector<const char*>& dimensions, const cycle::Quantity& quantity,
                                            Stored stored, const std::vector<std::size_t>& piece) {
  constexpr int kTypes[] = {NC_BYTE, NC_INT64, NC_FLOAT, NC_DOUBLE, NC_STRING};
  const int type = kTypes[static_cast<int>(stored)];
  const auto variable = define_variable(quantity, dimensions, type, Storage::kOpen);
  if (!variable) return variable;
  std::size_t count = 1;
  for (const std::size_t n : piece) count *= n;
  check(nc_def_var_chunking(file_, *variable, NC_CHUNKED, piece.data()), quantity.name);
  if (stored == Stored::kText) return variable;
  check(nc_def_var_deflate(file_, *variable, 1, 1, kBlockDeflateLevel), quantity.name);
  std::size_t bytes = 0;
  check(nc_inq_type(file_, type, nullptr, &bytes), quantity.name);
  check(nc_set_var_chunk_cache(file_, *variable, count * bytes, 1, 1.0F), quantity.name);
  const double none = std::numeric_limits<double>::quiet_NaN();
  if (stored == Stored::kDouble || stored == Stored::kSingle)
    check(nc_put_att_double(file_, *variable, "_FillValue", type, 1, &none), quantity.name);
  return variable;
}

void ResultFileWriter::put_block(int variable, const std::vector<std::size_t>& first,
                                 const std::vector<std::size_t>& count, const double* values) {
  check(nc_put_vara_double(file_, variable, first.data(), count.data(), values), "a block");
}

void ResultFileWriter::put_block(int variable, const std::vector<std::size_t>& first,
                                 const std::vector<std::size_t>& count, const float* values) {
  check(nc_put_vara_float(file_, variable, first.data(), count.data(), values), "a block");
}

void ResultFileWriter::put_block(int variable, const std::vector<std::size_t>& first,
                                 const std::vector<std::size_t>& count, const std::vector<std::string>& values) {
  std::vector<const char*> pointers;
  for (const std::string& value : values) pointers.push_back(value.c_str());
  check(nc_put_vara_string(file_, variable, first.data(), count.data(), pointers.data()), "a block");
}

void ResultFileWriter::close() {
  check(nc_close(std::exchange(file_, -1)), "the file");
  aside_->append(digest_trailer(file_sha256(aside_->path())));
}

std::string_view ResultFileWriter::bytes() {
  NC_memio content{};
  check(nc_close_memio(std::exchange(file_, -1), &content), "the file");
  content_.reset(content.memory);
  const std::size_t size = length_in_superblock(static_cast<const unsigned char*>(content.memory), content.size);
  if (content.size < size + kDigestTrailerSize) {
    void* const larger = std::realloc(content_.get(), size + kDigestTrailerSize);
    if (larger == nullptr) throw std::bad_alloc();
    static_cast<void>(content_.release());  // the larger block took over its bytes
    content_.reset(larger);
  }
  char* const bytes = static_cast<char*>(content_.get());
  std::memcpy(bytes + size, digest_trailer(sha256({bytes, size})).data(), kDigestTrailerSize);
  return {bytes, size + kDigestTrailerSize};
}

}  // namespace ringfilm::io
