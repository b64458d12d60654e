#include "reproduction.hpp"

#include <fmt/format.h>

#include <limits>

#include "progress.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/cycle/setup/setup.hpp"
#include "ringfilm/io/case/case_file.hpp"
#include "ringfilm/io/result/result_file.hpp"

namespace ringfilm::app {
namespace {

namespace fs = std::filesystem;

/// Crank angles at which the report can show film and pressure along the face: closer where the load is high.
std::string field_angles() {
  std::string list;
  for (int angle = 0; angle < 720; angle += 5) {
    const bool is_near_firing = angle <= 60 || angle >= 660;
    if (is_near_firing || angle % 10 == 0) list += (list.empty() ? "" : ", ") + fmt::format("\"{} degree\"", angle);
  }
  return "[" + list + "]";
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  if (fs::is_directory(folder, error)) return;
  if (!fs::create_directory(folder, error)) {
    throw InputError(
        folder.string() + ": this folder cannot be made: " + (error ? error.message() : "there is already a file"),
        "name another one with --output");
  }
}

}  // namespace

io::OutputClaim claimed_report(const fs::path& report) {
  make_folder(report.parent_path());
  io::check_can_write(report.string(), io::Sink::kFile);
  return io::OutputClaim(report.string());
}

std::vector<io::ResultDocument> computed(const std::vector<run::Request>& requests, int jobs) {
  std::vector<io::ResultDocument> documents;
  RunProgress progress;
  for (run::CycleOutcome& done : run::run_cycles(requests, jobs, &progress)) {
    if (done.stopped) throw *done.stopped;
    documents.push_back(std::move(done.document));
  }
  return documents;
}

std::string cells(const std::string& name, const std::vector<io::ResultDocument>& documents,
                  const EngineeringText& in_words) {
  std::string text;
  for (const io::ResultDocument& document : documents) {
    const double value = document.result.values.*cycle_quantity(name).value;
    text += fmt::format("{:>24}", in_words(name, value, error_of(document, name)));
  }
  return text;
}

cycle::Case case_for_report(const std::string& path, const io::Units& units) {
  cycle::Case input = io::read_case(path, {{"output.fields", field_angles()}}, units);
  cycle::prepare(input);
  return input;
}

double error_of(const io::ResultDocument& document, const std::string& quantity) {
  return document.errors ? document.errors->values.*cycle_quantity(quantity).value
                         : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace ringfilm::app
