#include "dataset_writer.hpp"

#include <algorithm>

namespace ringfilm::python {

py::object DatasetWriter::objects(const py::list& texts) {
  return py::module_::import("numpy").attr("array")(texts, py::arg("dtype") = py::dtype("O"));
}

std::optional<std::vector<py::ssize_t>> DatasetWriter::shape_of(const std::vector<const char*>& dimensions,
                                                                std::size_t n_values) {
  if (n_values == 0) return std::nullopt;
  if (dimensions.size() == 1) sizes_[dimensions.front()] = n_values;
  std::vector<py::ssize_t> shape;
  for (const char* dimension : dimensions) {
    if (!sizes_.contains(dimension)) return std::nullopt;
    shape.push_back(static_cast<py::ssize_t>(sizes_[dimension]));
  }
  return shape;
}

void DatasetWriter::put(const std::vector<const char*>& dimensions, const cycle::Quantity& quantity,
                        const py::object& values) {
  py::dict attributes;
  const auto describe = [&attributes](const char* name, const std::string& text) {
    if (!text.empty()) attributes[name] = text;
  };
  describe("units", quantity.unit);
  describe("long_name", quantity.long_name);
  describe("symbol", quantity.symbol);
  describe("source_equation", quantity.equation);
  py::tuple names(dimensions.size());
  for (std::size_t i = 0; i < dimensions.size(); ++i) names[i] = py::str(dimensions[i]);
  variables_[py::str(quantity.name)] = py::make_tuple(names, values, attributes);
}

}  // namespace ringfilm::python
