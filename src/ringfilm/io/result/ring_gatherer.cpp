#include "ringfilm/io/result/ring_gatherer.hpp"

#include <algorithm>
#include <limits>

namespace ringfilm::io {
namespace {

template <class Value>
Value missing() {
  if constexpr (std::is_floating_point_v<Value>) return std::numeric_limits<Value>::quiet_NaN();
  return Value{};
}

}  // namespace

void RingGatherer::set_length(const std::string& dimension, std::size_t length) {
  std::vector<long>& lengths = lengths_[dimension];
  lengths.resize(n_rings_, 0);
  lengths.back() = static_cast<long>(length);
}

std::size_t RingGatherer::longest(const std::string& dimension) const {
  const std::vector<long>& lengths = lengths_.at(dimension);
  return static_cast<std::size_t>(*std::max_element(lengths.begin(), lengths.end()));
}

void RingGatherer::put(const cycle::Quantity& quantity, const std::vector<const char*>& dimensions, Values values) {
  auto found = std::find_if(variables_.begin(), variables_.end(),
                            [&](const Variable& variable) { return variable.quantity.name == quantity.name; });
  if (found == variables_.end()) {
    found = variables_.insert(variables_.end(), {quantity, {dimensions.begin(), dimensions.end()}, {}});
  }
  found->of_ring[n_rings_ - 1] = std::move(values);
}

const RingGatherer::Values* RingGatherer::shared_coordinate(const Variable& variable) const {
  if (!is_coordinate(variable)) return nullptr;
  const auto size = [](const Values& values) { return std::visit([](const auto& of) { return of.size(); }, values); };
  const Values* longest = nullptr;
  for (const auto& [ring, values] : variable.of_ring) {
    if (longest == nullptr || size(values) > size(*longest)) longest = &values;
  }
  const auto is_part = [&](const Values& part) {
    return std::visit(
        [&](const auto& of) {
          const auto& all = std::get<std::decay_t<decltype(of)>>(*longest);
          return std::equal(of.begin(), of.end(), all.begin());
        },
        part);
  };
  const bool is_shared = std::all_of(variable.of_ring.begin(), variable.of_ring.end(),
                                     [&](const auto& one) { return is_part(one.second); });
  return is_shared ? longest : nullptr;
}

RingGatherer::Values RingGatherer::whole(const Variable& variable) const {
  std::vector<std::size_t> shape;
  std::size_t n = 1;
  for (const std::string& name : variable.dimensions) n *= shape.emplace_back(longest(name));
  const auto gathered = [&](const auto& example) -> Values {
    using Value = typename std::decay_t<decltype(example)>::value_type;
    std::vector<Value> all(n_rings_ * n, missing<Value>());
    for (const auto& [ring, stored] : variable.of_ring) {
      const auto& own = std::get<std::vector<Value>>(stored);
      std::vector<std::size_t> lengths;
      for (const std::string& name : variable.dimensions) {
        lengths.push_back(static_cast<std::size_t>(lengths_.at(name).at(ring)));
      }
      for (std::size_t i = 0; i < own.size(); ++i) all[ring * n + place_in(i, lengths, shape)] = own[i];
    }
    return all;
  };
  return std::visit(gathered, variable.of_ring.begin()->second);
}

}  // namespace ringfilm::io
