#pragma once
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "array_view.hpp"
#include "result_object.hpp"
#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/io/result/result_file_quantities.hpp"

namespace ringfilm::python {

/// Takes the same calls as io::ResultFileWriter, so that the one description of result files (result_file_layout.hpp)
/// is that of the xarray.Dataset, too: variables as (dimensions, array, attributes), numbers without a copy.
class DatasetWriter {
 public:
  static constexpr bool kReads = false;

  /// @param owner owner of all that is written; keeps its numbers alive
  explicit DatasetWriter(py::object owner) : owner_(std::move(owner)) {}

  template <class Value>
  void attribute(const char* name, const Value& value) {
    if constexpr (std::is_same_v<Value, bool>) {
      attributes_[name] = static_cast<int>(value);
    } else {
      attributes_[name] = value;
    }
  }

  template <class Row>
  void rows(const char* dimension, const std::vector<Row>& rows) {
    if (!rows.empty()) sizes_[dimension] = rows.size();
  }

  template <class Row, class Base, class Value, class Part = std::identity>
  void column(const char* dimension, const cycle::Quantity& quantity, const std::vector<Row>& rows, Value Base::*member,
              Part part = {}) {
    if (!sizes_.contains(dimension)) return;
    if constexpr (std::is_same_v<Value, double> && std::is_same_v<Row, Base>) {
      put({dimension}, quantity, column_view(rows, member, owner_));
    } else {
      put(quantity, {dimension}, io::stored_column(rows, member, part));
    }
  }

  void texts(const char* dimension, const cycle::Quantity& quantity, const std::vector<std::string>& values) {
    if (values.empty()) return;
    sizes_[dimension] = values.size();
    put({dimension}, quantity, objects(py::cast(values)));
  }

  template <class Number>
  void numbers(const std::vector<const char*>& dimensions, const cycle::Quantity& quantity,
               const std::vector<Number>& values) {
    if (const auto shape = shape_of(dimensions, values.size())) put(dimensions, quantity, view(values, *shape, owner_));
  }

  /// Numbers that nobody keeps.
  void numbers(const std::vector<const char*>& dimensions, const cycle::Quantity& quantity,
               std::vector<double>&& values) {
    if (const auto shape = shape_of(dimensions, values.size()))
      put(dimensions, quantity, py::array_t<double>(*shape, values.data()));
  }

  void dimension(const char* name, std::size_t size) {
    if (size > 0) sizes_[name] = size;
  }
  /// A copy over dimensions that exist; nothing where one of them is empty.
  template <class Value>
  void put(const cycle::Quantity& quantity, const std::vector<const char*>& dimensions,
           const std::vector<Value>& values) {
    std::vector<py::ssize_t> shape;
    for (const char* dimension : dimensions) {
      if (!sizes_.contains(dimension)) return;
      shape.push_back(static_cast<py::ssize_t>(sizes_[dimension]));
    }
    if constexpr (std::is_same_v<Value, std::string>) {
      put(dimensions, quantity, objects(py::cast(values)).attr("reshape")(shape));
    } else {
      using Stored = std::conditional_t<std::is_same_v<Value, long>, std::int64_t, Value>;
      put(dimensions, quantity, py::array_t<Stored>(shape, std::vector<Stored>(values.begin(), values.end()).data()));
    }
  }

  void scalar(const cycle::Quantity& quantity, double value) { put({}, quantity, py::float_(value)); }
  void scalar(const cycle::Quantity& quantity, const std::string& text) { put({}, quantity, py::str(text)); }

  const py::dict& attributes() const { return attributes_; }
  const py::dict& variables() const { return variables_; }

 private:
  static py::object objects(const py::list& texts);
  /// Nothing where there are no values, or a dimension does not exist.
  std::optional<std::vector<py::ssize_t>> shape_of(const std::vector<const char*>& dimensions, std::size_t n_values);
  void put(const std::vector<const char*>& dimensions, const cycle::Quantity& quantity, const py::object& values);

  py::object owner_;
  std::map<std::string, std::size_t> sizes_;
  py::dict attributes_, variables_;
};

}  // namespace ringfilm::python
