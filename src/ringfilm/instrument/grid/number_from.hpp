#pragma once
#include <charconv>
#include <optional>
#include <string_view>

namespace ringfilm::instrument {

/// The number that fills a text from its first to its last character; nothing: the text is not a number.
template <class Number>
std::optional<Number> number_from(std::string_view text) {
  Number value{};
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || rest != text.data() + text.size()) return std::nullopt;
  return value;
}

/// The number that fills a text, with or without a plus sign before it; nothing: the text is not a number.
template <class Number>
std::optional<Number> signed_number_from(std::string_view text) {
  return number_from<Number>(text.substr(text.starts_with('+') ? 1 : 0));
}

}  // namespace ringfilm::instrument
