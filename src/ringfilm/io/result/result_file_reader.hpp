#pragma once
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/io/result/result_file_netcdf.hpp"

namespace ringfilm::io {

/// Reads what ResultFileWriter wrote, call by call the same names. Sizes come from the file and are checked against
/// each other before anything is copied. Throws InputError.
class ResultFileReader {
 public:
  static constexpr bool kReads = true;

  /// @param path only named in error messages; @param bytes without their digest_trailer; must outlive the reader
  ResultFileReader(const std::string& path, std::string_view bytes);
  ResultFileReader(const ResultFileReader&) = delete;
  ResultFileReader& operator=(const ResultFileReader&) = delete;
  ~ResultFileReader();

  /// How many rings a pack has; 0: the result of one ring.
  std::size_t n_rings() const { return length_in_file("ring"); }
  /// From now on all that is read is that of one ring of a pack (see RingGatherer), from 0.
  void choose_ring(std::size_t ring) { ring_ = ring; }

  /// Does the file have that global attribute?
  bool has_attribute(const char* name) const;
  /// Does it have that variable?
  bool has_variable(const std::string& name) const;

  void attribute(const char* name, std::string& text) const;
  void attribute(const char* name, double& value) const;
  void attribute(const char* name, long& value) const;
  void attribute(const char* name, bool& value) const;

  template <class Row>
  void rows(const char* dimension, std::vector<Row>& rows) const {
    rows.assign(length(dimension), Row{});
  }

  template <class Row, class Base, class Value, class Part = std::identity>
  void column(const char* dimension, const cycle::Quantity& quantity, std::vector<Row>& rows, Value Base::*member,
              Part part = {}) const {
    std::vector<decltype(in_file(std::declval<Value&>()))> values;
    read({dimension}, quantity, values);
    for (std::size_t i = 0; i < values.size(); ++i) restore(values[i], part(rows[i]).*member);
  }

  void texts(const char* dimension, const cycle::Quantity& quantity, std::vector<std::string>& values) const {
    read({dimension}, quantity, values);
  }
  template <class Number>
  void numbers(const std::vector<const char*>& dimensions, const cycle::Quantity& quantity,
               std::vector<Number>& values) const {
    read(dimensions, quantity, values);
  }
  void scalar(const cycle::Quantity& quantity, double& value) const;
  void scalar(const cycle::Quantity& quantity, std::string& text) const;
  /// Every scalar variable whose name begins with `prefix`, by the rest of its name.
  void scalars(const std::string& prefix, std::map<std::string, double>& values) const;

 private:
  // The type in the file for a member of that type, and back.
  static std::string in_file(const std::string&);
  static signed char in_file(const bool&);
  static long in_file(const long&);
  static double in_file(const double&);
  static double in_file(const std::optional<double>&);
  static void restore(signed char value, bool& member) { member = value != 0; }
  static void restore(double value, std::optional<double>& member) {
    if (!std::isnan(value)) member = value;
  }
  template <class Value>
  static void restore(const Value& value, Value& member) {
    member = value;
  }

  /// Rows of a dimension, 0 where the file has none of that name; of a ring of a pack those that it has.
  std::size_t length(const char* dimension) const;
  std::size_t length_in_file(const char* dimension) const;
  /// The number of a variable of that type that has as many values as its dimensions; nothing where there are none.
  std::optional<int> find(const std::vector<const char*>& dimensions, const std::string& name, int type,
                          std::size_t& count) const;
  template <class Value>
  void read(const std::vector<const char*>& dimensions, const cycle::Quantity& quantity,
            std::vector<Value>& values) const;
  template <class Value>
  void read_one(const cycle::Quantity& quantity, Value& value) const;
  /// All values of a variable.
  template <class Value>
  void get(int variable, const std::string& name, std::vector<Value>& values) const;
  /// Refuses a global attribute that is not a single number.
  void check_single(const char* name) const;
  [[noreturn]] void refuse(const std::string& what) const;
  void check(int status, const std::string& what) const;

  std::string path_;
  NetcdfInUse in_use_;
  int file_ = -1;
  std::optional<std::size_t> ring_;
};

}  // namespace ringfilm::io
