#include "ringfilm/io/study/document_reader.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "ringfilm/io/text/source_text.hpp"

namespace ringfilm::io {

void append_case_faults(const InputError& error, const SourceMark& mark, std::vector<Fault>& faults) {
  for (const Fault& f : error.faults()) {
    const bool in_file = f.mark.line > 0 && f.mark.file != "--set";
    faults.push_back(in_file ? f : Fault{mark, f.message, f.remedy});
  }
}

DocumentReader::DocumentReader(const std::string& path)
    : DocumentReader(path, std::filesystem::path(path).parent_path().string()) {}

DocumentReader::DocumentReader(const std::string& path, const std::string& folder) : path_(path), folder_(folder) {}

TomlValue DocumentReader::read_document(DocumentKind kind, const std::string& role) {
  const SourceText source = read_source_text(path_, path_, kMaxToml);
  record({role, path_, source.sha256});
  TomlValue root = parse_toml(source);
  check_document_kind(root, kind, path_);
  return root;
}

void DocumentReader::record(const cycle::InputFile& file) {
  if (recorded_.insert(file.path + "\n" + file.sha256).second) files_.push_back(file);
}

void DocumentReader::record(const cycle::Case& input) {
  for (const cycle::InputFile& file : input.files) record(file);
}

std::string DocumentReader::stem() const { return std::filesystem::path(path_).stem().string(); }

bool DocumentReader::is_one_ring(const cycle::Case& input, const std::string& path, const std::string& document,
                                 const SourceMark& mark) {
  if (input.problem == cycle::Problem::kPad) {
    faults_.push_back({mark, fmt::format("{} is a pad", path), document + " is about a ring over engine cycles"});
    return false;
  }
  if (input.is_pack()) {
    faults_.push_back({mark, fmt::format("{} is a pack of {} rings", path, input.rings.size()),
                       document + " is about one ring: write it as [ring], with ring.pressure_above and "
                                  "ring.pressure_below"});
    return false;
  }
  return true;
}

}  // namespace ringfilm::io
