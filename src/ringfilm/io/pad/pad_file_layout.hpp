#pragma once
#include <algorithm>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "ringfilm/io/pad/pad_output.hpp"
#include "ringfilm/io/result/provenance_attributes.hpp"

/// What a result file of a pad holds, reported once to whoever takes the calls of ResultFileWriter.
namespace ringfilm::io {

inline constexpr long kPadSchema = 1;

template <class File>
void put_pad_fields(File& file, const pad::PadResult& result) {
  const auto& columns = pad::profile_quantities();
  const auto find = [&columns](const std::string& name) {
    return *std::find_if(columns.begin(), columns.end(), [&](const auto& quantity) { return quantity.name == name; });
  };
  std::vector<const char*> dimensions{"time", "x"};
  file.numbers({"x"}, find("x"), result.x);
  if (!result.y.empty()) {
    file.numbers({"y"}, pad::place_across(), result.y);
    dimensions = {"time", "y", "x"};
  }
  const std::vector<pad::Profile>& instants = result.y.empty() ? result.profiles : result.fields;
  for_each_member<pad::Profile>([&](const auto& member) {
    if constexpr (std::is_same_v<decltype(member.value), std::vector<double> pad::Profile::*>) {
      std::vector<double> values;
      for (const pad::Profile& instant : instants) {
        const std::vector<double>& of_instant = instant.*member.value;
        values.insert(values.end(), of_instant.begin(), of_instant.end());
      }
      file.numbers(dimensions, find(member.name), std::move(values));
    }
  });
}

template <class File>
void put_pad_words(File& file, const PadDocument& document) {
  std::vector<std::string> inputs, notes = document.input_notes;
  for (const CaseEntry& entry : document.inputs) {
    inputs.push_back(entry.key + " = " + entry.value + (entry.assumed ? "  # assumed" : ""));
  }
  for (const cycle::Note& note : document.result.notes) notes.push_back(note.topic + ": " + note.message);
  const auto put = [&file](const char* name, const char* long_name, const std::vector<std::string>& lines) {
    if (!lines.empty()) file.texts(name, {name + std::string("_text"), "", "", long_name, "", ""}, lines);
  };
  put("input", "the case as it was used, SI", inputs);
  put("note", "what to consider before using the numbers", notes);
}

template <class File>
void put_pad(File& file, const PadDocument& document) {
  file.attribute("Conventions", std::string("CF-1.10"));
  file.attribute("ringfilm_pad_schema", kPadSchema);
  file.attribute("title", document.title);
  exchange_provenance(file, document.provenance);
  file.attribute("complete", document.result.complete);
  for (const pad::PadQuantity& quantity : pad::reported_quantities(document.result)) {
    std::vector<double> values;
    for (const pad::Sample& sample : document.result.samples) values.push_back(sample.*quantity.value);
    file.numbers({"time"}, quantity, std::move(values));
  }
  put_pad_fields(file, document.result);
  put_pad_words(file, document);
}

}  // namespace ringfilm::io
