#pragma once
#include <utility>
#include <vector>

#include "bindings.hpp"

/// Arrays of numpy over numbers that C++ keeps.
namespace ringfilm::python {

/// Numbers that somebody else keeps: a read-only array without a copy; `owner` lives as long as it.
template <class Number>
py::array view(const Number* data, std::vector<py::ssize_t> shape, std::vector<py::ssize_t> strides,
               const py::handle& owner) {
  py::array array(py::dtype::of<Number>(), std::move(shape), std::move(strides), data, owner);
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

template <class Number>
py::array view(const std::vector<Number>& values, std::vector<py::ssize_t> shape, const py::handle& owner) {
  py::ssize_t size = 1;
  for (const py::ssize_t length : shape) size *= length;
  if (static_cast<std::size_t>(size) != values.size()) shape = {static_cast<py::ssize_t>(values.size())};
  std::vector<py::ssize_t> strides(shape.size(), static_cast<py::ssize_t>(sizeof(Number)));
  for (std::size_t i = shape.size(); i-- > 1;) strides[i - 1] = strides[i] * shape[i];
  return view(values.data(), std::move(shape), std::move(strides), owner);
}

template <class Number>
py::array view(const std::vector<Number>& values, const py::handle& owner) {
  return view(values, {static_cast<py::ssize_t>(values.size())}, owner);
}

/// One member of all rows.
template <class Row>
py::array column_view(const std::vector<Row>& rows, double Row::*member, const py::handle& owner) {
  static const double nothing = 0;
  const double* first = rows.empty() ? &nothing : &(rows.front().*member);
  return view(first, {static_cast<py::ssize_t>(rows.size())}, {static_cast<py::ssize_t>(sizeof(Row))}, owner);
}

}  // namespace ringfilm::python
