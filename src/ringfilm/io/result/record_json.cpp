#include "ringfilm/io/result/record_json.hpp"

namespace ringfilm::io {

using nlohmann::ordered_json;

ordered_json notes_array(const std::vector<std::string>& of_input, const std::vector<cycle::Note>& of_result) {
  ordered_json notes = ordered_json::array();
  for (const std::string& message : of_input) notes.push_back({{"topic", "input"}, {"message", message}});
  for (const cycle::Note& note : of_result) notes.push_back(record_object(note));
  return notes;
}

ordered_json assumed_object(const std::vector<CaseEntry>& inputs) {
  ordered_json assumed = ordered_json::object();
  for (const CaseEntry& entry : inputs) {
    if (entry.assumed) assumed[entry.key] = entry.shown;
  }
  return assumed;
}

void put_provenance(const Provenance& provenance, ordered_json& object) {
  for_each_member<Provenance>([&](const auto& member) {
    if (const std::string& text = provenance.*member.value; !text.empty()) object[member.name] = text;
  });
}

std::string json_text(const ordered_json& object) {
  return object.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace ringfilm::io
