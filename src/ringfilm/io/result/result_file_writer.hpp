#pragma once
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/io/result/result_file_netcdf.hpp"
#include "ringfilm/io/result/result_file_quantities.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"

namespace ringfilm::io {

/// Makes a NetCDF-4 file in memory, or on the disk where room for all of it was set aside: the library cannot be
/// trusted any more once it met a full disk. One half of the pair with ResultFileReader: `exchange` in
/// result_file_layout.hpp calls either. Throws OutputError.
class ResultFileWriter {
 public:
  static constexpr bool kReads = false;

  /// @param path how errors name the file
  explicit ResultFileWriter(const std::string& path);
  /// On the disk, for what is written block by block. @param most_bytes that it may become; see AsideFile::reserve
  ResultFileWriter(const std::string& path, AsideFile& aside, std::uint64_t most_bytes);
  ResultFileWriter(const ResultFileWriter&) = delete;
  ResultFileWriter& operator=(const ResultFileWriter&) = delete;
  ~ResultFileWriter();

  void attribute(const char* name, const std::string& text);
  void attribute(const char* name, double value);
  void attribute(const char* name, long value);
  void attribute(const char* name, bool value) { attribute(name, static_cast<long>(value)); }

  /// A dimension of as many rows; none at all where there are no rows (NetCDF takes length 0 for "unlimited").
  template <class Row>
  void rows(const char* dimension, const std::vector<Row>& rows) {
    define_dimension(dimension, rows.size());
  }

  /// One variable over the rows: a member of each, or of a part of each.
  template <class Row, class Base, class Value, class Part = std::identity>
  void column(const char* dimension, const cycle::Quantity& quantity, const std::vector<Row>& rows, Value Base::*member,
              Part part = {}) {
    put(quantity, {dimension}, stored_column(rows, member, part));
  }

  /// One variable of texts over a dimension of its own, or over one of the same length.
  void texts(const char* dimension, const cycle::Quantity& quantity, const std::vector<std::string>& values);

  /// An array over dimensions that exist by now (nothing if one of them is empty); defines a single missing one. Single
  /// precision is compressed; over angle, y and x in pieces of one angle each. Throws std::logic_error if the values do
  /// not fit.
  template <class Value>
  void numbers(const std::vector<const char*>& dimensions, const cycle::Quantity& quantity,
               const std::vector<Value>& values);

  void scalar(const cycle::Quantity& quantity, double value) { put(quantity, {}, std::vector<double>{value}); }
  /// A text of any length; an attribute ends at 64 KiB.
  void scalar(const cycle::Quantity& quantity, const std::string& text) {
    put(quantity, {}, std::vector<std::string>{text});
  }

  /// One more attribute of a variable that is there; nothing where the variable was omitted.
  void describe(const std::string& variable, const char* attribute, const std::string& text);
  void describe(const std::string& variable, const char* attribute, double value);

  /// A dimension by its length; none where that is 0.
  void dimension(const char* name, std::size_t size) { define_dimension(name, size); }

  /// What the numbers of a variable that is written block by block are in the file.
  enum class Stored { kByte, kInteger, kSingle, kDouble, kText };

  /// A variable over dimensions that exist, for `put_block`. Stored compressed in pieces of which each holds `piece`
  /// numbers along each dimension; a block should be whole pieces, since no more than one is kept in memory.
  /// @returns its number, or nothing where one of the dimensions is empty
  std::optional<int> blocks(const std::vector<const char*>& dimensions, const cycle::Quantity& quantity, Stored stored,
                            const std::vector<std::size_t>& piece);
  /// @param first place of the block along each dimension @param count its lengths
  void put_block(int variable, const std::vector<std::size_t>& first, const std::vector<std::size_t>& count,
                 const double* values);
  void put_block(int variable, const std::vector<std::size_t>& first, const std::vector<std::size_t>& count,
                 const float* values);
  void put_block(int variable, const std::vector<std::size_t>& first, const std::vector<std::size_t>& count,
                 const std::vector<std::string>& values);

  /// A variable over dimensions that exist; nothing where one of them is empty.
  template <class Value>
  void put(const cycle::Quantity& quantity, const std::vector<const char*>& dimensions,
           const std::vector<Value>& values);

  /// The whole file with its digest_trailer, without a copy: it lives as long as the writer. Call once, at the end.
  std::string_view bytes();
  /// Closes a file on the disk and appends its digest_trailer. Call once, at the end.
  void close();

 private:
  /// How a variable is laid out: here, as fits what is written at once, or by whoever defines it.
  enum class Storage { kWhole, kOpen };

  void define_dimension(const char* name, std::size_t size);
  /// @returns its number, or nothing where one of the dimensions is empty
  std::optional<int> define_variable(const cycle::Quantity& quantity, const std::vector<const char*>& dimensions,
                                     int type, Storage storage = Storage::kWhole);
  void check(int status, const std::string& what) const;

  std::string path_;
  NetcdfInUse in_use_;
  int file_ = -1;
  AsideFile* aside_ = nullptr;                                           ///< file on the disk; nullptr: in memory
  std::unique_ptr<void, void (*)(void*)> content_{nullptr, &std::free};  ///< bytes of the closed file
};

}  // namespace ringfilm::io
