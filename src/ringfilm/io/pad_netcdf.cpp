#include "ringfilm/io/pad_netcdf.hpp"

#include <algorithm>

#include "ringfilm/io/atomic_file.hpp"
#include "ringfilm/io/result_file_writer.hpp"

namespace ringfilm::io {
namespace {

constexpr long kPadSchema = 1;

void write_numbers(ResultFileWriter& file, const std::vector<pad::PadQuantity>& quantities,
                   const std::vector<pad::Sample>& samples) {
  for (const pad::PadQuantity& quantity : quantities) {
    std::vector<double> values;
    for (const pad::Sample& sample : samples) values.push_back(sample.*quantity.value);
    file.numbers({"time"}, quantity, values);
  }
}

void write_fields(ResultFileWriter& file, const pad::PadResult& result) {
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
  const auto write = [&](const char* name, std::vector<double> pad::Profile::*member) {
    std::vector<double> values;
    for (const pad::Profile& instant : instants) {
      values.insert(values.end(), (instant.*member).begin(), (instant.*member).end());
    }
    file.numbers(dimensions, find(name), values);
  };
  write("film_thickness", &pad::Profile::film_thickness);
  write("pressure", &pad::Profile::pressure);
  write("fill", &pad::Profile::fill);
}

void write_words(ResultFileWriter& file, const PadDocument& document) {
  std::vector<std::string> inputs, notes = document.input_notes;
  for (const CaseEntry& entry : document.inputs) {
    inputs.push_back(entry.key + " = " + entry.value + (entry.assumed ? "  # assumed" : ""));
  }
  for (const cycle::Note& note : document.result.notes) notes.push_back(note.topic + ": " + note.message);
  const auto write = [&file](const char* name, const char* long_name, const std::vector<std::string>& lines) {
    if (!lines.empty()) file.texts(name, {name + std::string("_text"), "", "", long_name, "", ""}, lines);
  };
  write("input", "the case as it was used, SI", inputs);
  write("note", "what to know before using the numbers", notes);
}

}  // namespace

void write_pad(const std::string& path, const PadDocument& document) {
  ResultFileWriter file(path);
  file.attribute("Conventions", std::string("CF-1.10"));
  file.attribute("ringfilm_pad_schema", kPadSchema);
  file.attribute("title", document.title);
  file.attribute("program", document.provenance.program);
  file.attribute("commit", document.provenance.commit);
  file.attribute("compiler", document.provenance.compiler);
  file.attribute("kernels", document.provenance.kernels);
  file.attribute("complete", document.result.complete);
  write_numbers(file, pad::pad_quantities(), document.result.samples);
  if (!document.result.y.empty()) write_numbers(file, pad::width_quantities(), document.result.samples);
  write_fields(file, document.result);
  write_words(file, document);
  write_atomically(path, file.bytes());
}

}  // namespace ringfilm::io
