#pragma once
#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/io/result/result_file_quantities.hpp"

namespace ringfilm::io {

/// Takes the calls of ResultFileWriter for one ring of a pack after the other, and gives each variable the dimension
/// `ring` in front. A coordinate (a variable with the name of its one dimension) that all rings share has no ring; one
/// that they do not share is COORDINATE_of_ring, since readers take a variable of that name for one along its dimension
/// alone. Where rings have different lengths of a dimension (notes, nodes of graded cells, crank angles of one that
/// stopped) the longest counts: what others lack is NaN, 0 or an empty text, and `n_DIMENSION` has the lengths. Global
/// attributes of a ring become variables; its texts, of which all rings have the same, do not, but `ring_title`.
class RingGatherer {
 public:
  static constexpr bool kReads = false;
  using Values = std::variant<std::vector<double>, std::vector<float>, std::vector<long>, std::vector<signed char>,
                              std::vector<std::string>>;

  void next_ring() { ++n_rings_; }

  void attribute(const std::string& name, const std::string& text) {
    if (name == "title")
      put(described("ring_title", "", "title of the case and name of the ring"), {}, std::vector<std::string>{text});
  }
  void attribute(const std::string& name, double value) { put(count(name, ""), {}, std::vector<double>{value}); }
  void attribute(const std::string& name, long value) { put(count(name, ""), {}, std::vector<long>{value}); }
  void attribute(const std::string& name, bool value) { put(count(name, ""), {}, std::vector<signed char>{value}); }

  template <class Row>
  void rows(const char* dimension, const std::vector<Row>& rows) {
    set_length(dimension, rows.size());
  }

  template <class Row, class Base, class Value, class Part = std::identity>
  void column(const char* dimension, const cycle::Quantity& quantity, const std::vector<Row>& rows, Value Base::*member,
              Part part = {}) {
    put(quantity, {dimension}, stored_column(rows, member, part));
  }

  void texts(const char* dimension, const cycle::Quantity& quantity, const std::vector<std::string>& values) {
    set_length(dimension, values.size());
    put(quantity, {dimension}, values);
  }
  template <class Number>
  void numbers(const std::vector<const char*>& dimensions, const cycle::Quantity& quantity,
               const std::vector<Number>& values) {
    if (dimensions.size() == 1) set_length(dimensions.front(), values.size());
    put(quantity, dimensions, values);
  }
  void scalar(const cycle::Quantity& quantity, double value) { put(quantity, {}, std::vector<double>{value}); }
  void scalar(const cycle::Quantity& quantity, const std::string& text) {
    put(quantity, {}, std::vector<std::string>{text});
  }

  /// Hands everything on: dimensions by their lengths, then `put(quantity, dimensions, values)`.
  template <class File>
  void write(File& file) const {
    file.dimension("ring", n_rings_);
    for (const auto& [name, lengths] : lengths_) file.dimension(name.c_str(), longest(name));
    for (auto [name, lengths] : lengths_) {
      lengths.resize(n_rings_, 0);
      file.put(count("n_" + name, "entries along " + name + " that the ring has"), {"ring"}, lengths);
    }
    std::vector<long> numbers(n_rings_);
    for (std::size_t i = 0; i < n_rings_; ++i) numbers[i] = static_cast<long>(i + 1);
    file.put(count("ring", "ring of the pack, 1 next to the chamber"), {"ring"}, numbers);
    for (const Variable& variable : variables_) {
      std::vector<const char*> dimensions{"ring"};
      for (const std::string& name : variable.dimensions) dimensions.push_back(name.c_str());
      cycle::Quantity quantity = variable.quantity;
      if (const Values* shared = shared_coordinate(variable)) {
        std::visit([&](const auto& values) { file.put(quantity, {dimensions.back()}, values); }, *shared);
        continue;
      }
      if (is_coordinate(variable)) quantity.name += "_of_ring";
      std::visit([&](const auto& values) { file.put(quantity, dimensions, values); }, whole(variable));
    }
  }

 private:
  struct Variable {
    cycle::Quantity quantity;
    std::vector<std::string> dimensions;
    std::map<std::size_t, Values> of_ring;  ///< by ring, from 0
  };
  void put(const cycle::Quantity& quantity, const std::vector<const char*>& dimensions, Values values);
  void set_length(const std::string& dimension, std::size_t length);
  std::size_t longest(const std::string& dimension) const;
  Values whole(const Variable& variable) const;
  static bool is_coordinate(const Variable& variable) {
    return variable.dimensions.size() == 1 && variable.dimensions.front() == variable.quantity.name;
  }
  /// The longest of a coordinate of which all other rings have a part from its beginning; else nullptr.
  const Values* shared_coordinate(const Variable& variable) const;

  std::size_t n_rings_ = 0;
  std::map<std::string, std::vector<long>> lengths_;  ///< lengths of each dimension, by ring
  std::vector<Variable> variables_;                   ///< variables in the order of the file
};

}  // namespace ringfilm::io
