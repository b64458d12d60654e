#pragma once
#include <nlohmann/json.hpp>
#include <string>

namespace example {

/// What is between the marks of the data element, read by a JSON parser that shares no line with the page.
inline nlohmann::json data_of(const std::string& page) {
  const std::string begin = "id=\"result-data\">";
  const std::size_t from = page.find(begin) + begin.size();
  return nlohmann::json::parse(page.substr(from, page.find("</script>", from) - from));
}

}  // namespace example
