#include "inverse/inverse_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "ringfilm/base/error.hpp"
#include "text/shared_options.hpp"

namespace ringfilm::app {

void declare_inverse(CommandOptions& add, InverseRequest& request, const InverseWords& words) {
  add.text(words.file, request.path, "", words.meaning)->required();
  const CLI::Option* output = add.text("-o,--output", request.output, "OUT", words.output);
  add.flag("--json", request.json, words.printed);
  add.flag("--resume", request.resume, "continue with the cases that are there; this is always done");
  add.flag("--overwrite", request.overwrite, "compute all cases anew");
  add_threads(add, request.threads);
  add.rule([=, &request](Faults&) {
    if (request.resume && request.overwrite) {
      throw InputError("--resume keeps the cases that are there, --overwrite computes them anew",
                       "keep one of the two");
    }
    if (!is_stated(output)) request.output = std::filesystem::path(request.path).stem().string();
  });
}

std::string prepared_store(const InverseRequest& request) {
  namespace fs = std::filesystem;
  std::error_code error;
  fs::create_directories(request.output, error);
  if (error || !fs::is_directory(request.output)) {
    throw OutputError(fmt::format("{}: the folder could not be made: {}", request.output, error.message()));
  }
  std::string path = in_folder(request.output, "points.jsonl");
  if (request.overwrite) fs::remove(path, error);
  if (error) throw OutputError(fmt::format("{}: could not be removed: {}", path, error.message()));
  return path;
}

run::InverseOptions inverse_options(const InverseRequest& request, const StopRequest& stop) {
  run::InverseOptions options;
  options.threads = request.threads;
  options.pulse = [&stop] {
    if (stop.is_made()) {
      throw stop.stopped("stopped: all cases that were computed are kept; the same command continues with them");
    }
  };
  return options;
}

std::string in_folder(const std::string& folder, const std::string& name) {
  return (std::filesystem::path(folder) / name).string();
}

std::string aligned_table(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      line += i == 0 ? fmt::format("  {:<{}}", row[i], widths[i]) : fmt::format("  {:>{}}", row[i], widths[i]);
    }
    text += line + "\n";
  }
  return text;
}

}  // namespace ringfilm::app
