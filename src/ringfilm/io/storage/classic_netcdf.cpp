#include "ringfilm/io/storage/classic_netcdf.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <limits>

namespace ringfilm::io {
namespace {

enum Tag : std::uint32_t { kAbsent = 0, kDimensions = 10, kVariables = 11, kAttributes = 12 };
enum Type : std::uint32_t {
  kByte = 1,
  kChar,
  kShort,
  kInt,
  kFloat,
  kDouble,
  kUnsignedByte,
  kUnsignedShort,
  kUnsignedInt,
  kInt64,
  kUnsignedInt64
};

std::size_t size_of(std::uint32_t type) {
  constexpr std::array<std::size_t, 12> kSizes = {0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8};
  if (type == 0 || type >= kSizes.size()) throw ClassicNetcdfError("a type of numbers that does not exist");
  return kSizes[type];
}

/// Numbers are stored with their highest byte first.
std::uint64_t whole_number(std::string_view bytes) {
  std::uint64_t value = 0;
  for (const char byte : bytes) value = value << 8 | static_cast<unsigned char>(byte);
  return value;
}

double number(std::uint32_t type, std::string_view bytes) {
  const std::uint64_t value = whole_number(bytes);
  switch (type) {
    case kByte:
      return static_cast<std::int8_t>(value);
    case kShort:
      return static_cast<std::int16_t>(value);
    case kInt:
      return static_cast<std::int32_t>(value);
    case kFloat:
      return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(value)));
    case kDouble:
      return std::bit_cast<double>(value);
    case kInt64:
      return static_cast<double>(static_cast<std::int64_t>(value));
    default:
      return static_cast<double>(value);
  }
}

class Parser {
 public:
  explicit Parser(std::string_view bytes) : bytes_(bytes) {}

  std::map<std::string, StoredVariable> variables() {
    const std::string_view magic = take(4);
    version_ = magic[3];
    if (magic.substr(0, 3) != "CDF" || (version_ != 1 && version_ != 2 && version_ != 5)) {
      throw ClassicNetcdfError("a version that is not known");
    }
    count();  // records
    for (std::uint64_t n = list(kDimensions); n > 0; --n) {
      name();
      lengths_.push_back(count());
    }
    StoredVariable of_file;
    read_attributes(of_file);
    std::map<std::string, StoredVariable> all;
    for (std::uint64_t n = list(kVariables); n > 0; --n) {
      const std::string called = name();
      all[called] = variable();
    }
    return all;
  }

 private:
  std::string_view take(std::uint64_t n) {
    if (n > bytes_.size() - at_) throw ClassicNetcdfError("it ends too early");
    const std::string_view taken = bytes_.substr(at_, n);
    at_ += n;
    return taken;
  }
  std::string_view take_padded(std::uint64_t n) {
    const std::string_view taken = take(n);
    take((4 - n % 4) % 4);
    return taken;
  }
  std::uint32_t word() { return static_cast<std::uint32_t>(whole_number(take(4))); }
  std::uint64_t count() { return whole_number(take(version_ == 5 ? 8 : 4)); }
  std::string name() { return std::string(take_padded(count())); }

  std::uint64_t list(Tag requested) {
    const std::uint32_t tag = word();
    const std::uint64_t n = count();
    if (tag != requested && !(tag == kAbsent && n == 0)) throw ClassicNetcdfError("a list without its tag");
    return n;
  }

  void read_attributes(StoredVariable& variable) {
    for (std::uint64_t n = list(kAttributes); n > 0; --n) {
      const std::string called = name();
      const std::uint32_t type = word();
      const std::uint64_t size = size_of(type), many = count();
      if (many > bytes_.size()) throw ClassicNetcdfError("it ends too early");
      const std::string_view value = take_padded(many * size);
      if (called == "units" && type == kChar) variable.units = std::string(value.substr(0, value.find('\0')));
      if (called == "scale_factor" || called == "add_offset") variable.packed_by = called;
      if ((called == "_FillValue" || called == "missing_value") && type != kChar && many == 1) {
        variable.missing.push_back(number(type, value));
        variable.has_fill = variable.has_fill || called == "_FillValue";
      }
    }
  }

  StoredVariable variable() {
    StoredVariable variable;
    std::uint64_t values = 1;
    for (std::uint64_t n = count(); n > 0; --n) {
      const std::uint64_t dimension = count();
      if (dimension >= lengths_.size()) throw ClassicNetcdfError("a dimension that does not exist");
      const std::uint64_t length = lengths_[dimension];
      variable.dimensions.push_back(static_cast<int>(dimension));
      variable.lengths.push_back(length);
      // More than the file is long are reported when they are required.
      values = length > bytes_.size() || values > bytes_.size() ? std::numeric_limits<std::uint32_t>::max()
                                                                : values * length;
    }
    read_attributes(variable);
    const std::uint32_t type = word();
    const std::size_t size = size_of(type);
    variable.add_default_fill(static_cast<int>(type));
    count();  // size in the file, which the lengths state as well
    const std::uint64_t begin = whole_number(take(version_ == 1 ? 4 : 8));
    variable.values = [bytes = bytes_, type, size, begin, values] {
      if (type == kChar) throw ClassicNetcdfError("text where numbers are required");
      if (begin > bytes.size() || values > (bytes.size() - begin) / size) throw ClassicNetcdfError("it ends too early");
      std::vector<double> all;
      all.reserve(values);
      for (std::uint64_t k = 0; k < values; ++k) all.push_back(number(type, bytes.substr(begin + k * size, size)));
      return all;
    };
    return variable;
  }

  std::string_view bytes_;
  std::uint64_t at_ = 0;
  char version_ = 1;
  std::vector<std::uint64_t> lengths_;
};

}  // namespace

std::map<std::string, StoredVariable> classic_netcdf_variables(std::string_view bytes) {
  return Parser(bytes).variables();
}

}  // namespace ringfilm::io
