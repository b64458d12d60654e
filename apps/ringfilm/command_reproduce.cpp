#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <iostream>

#include "commands.hpp"
#include "computation.hpp"
#include "engineering_text.hpp"
#include "ringfilm/io/atomic_file.hpp"
#include "ringfilm/io/published_file.hpp"
#include "ringfilm/report/html.hpp"

namespace ringfilm::app {
namespace {

namespace fs = std::filesystem;

/// The rings of the publication, in the order of their life.
constexpr std::array kRings = {"new", "run-in", "embedded"};
constexpr const char* kPublication = "styles2014";

void make_folder(const fs::path& folder) {
  std::error_code error;
  if (fs::is_directory(folder, error)) return;
  if (!fs::create_directory(folder, error)) {
    throw InputError(
        folder.string() + ": this folder cannot be made: " + (error ? error.message() : "a file stands there"),
        "name another one with --output");
  }
}

io::ResultDocument computed_ring(const fs::path& cases, const std::string& ring) {
  const cycle::Case input = io::read_case((cases / (ring + ".toml")).string());
  Computation done = computation(input, LedgerWanted::kComputed, ring);
  if (done.stopped) throw *done.stopped;
  done.document.comparison = study::compare(
      done.document.result, io::read_published((cases / "published.toml").string(), ring), done.document.ledger);
  return done.document;
}

std::string comparison_table(const std::string& ring, const std::vector<study::ComparisonRow>& rows) {
  const EngineeringText in_words;
  std::string text = fmt::format("{} ring\n", ring);
  text += fmt::format("  {:<66}{:>13}{:>13}{:>10}\n", "", "published", "computed", "deviation");
  for (const study::ComparisonRow& row : rows) {
    const study::PublishedValue& published = row.published;
    text += fmt::format("  {:<66}{:>13}{:>13}{:>+9.1f} %\n", published.statement,
                        in_words(published.quantity, published.value), in_words(published.quantity, row.computed),
                        100 * row.deviation);
    text += "      " + published.source;
    if (row.with_strongest_setting) {
      text +=
          fmt::format("; {} with {}", in_words(published.quantity, *row.with_strongest_setting), row.strongest_setting);
    }
    text += "\n";
  }
  return text;
}

}  // namespace

void reproduce(const ReproduceOptions& options) {
  if (options.publication != kPublication) {
    throw InputError("no publication is called " + options.publication, "known: " + std::string(kPublication));
  }
  const fs::path folder = options.folder.empty() ? fs::path(kPublication) : fs::path(options.folder);
  const fs::path cases = fs::path(io::shipped_folder()) / "cases" / kPublication;
  make_folder(folder);
  const std::string page = (folder / "report.html").string();
  io::check_can_write(page, io::Sink::kFile);

  std::cout << "Styles et al. 2014: three rings over one engine cycle at 1500 rpm and 120 degC\n"
            << "cylinder pressure: SYNTHETIC, made for this project; the paper's own trace is only a picture\n\n";
  std::vector<io::ResultDocument> documents;
  for (const std::string ring : kRings) {
    documents.push_back(computed_ring(cases, ring));
    io::write_result((folder / (ring + ".nc")).string(), documents.back());
    std::cout << comparison_table(ring, documents.back().comparison) << "\n";
  }
  io::write_atomically(page, ringfilm::report::report_page(documents, {}));
  std::cout << "results: " << (folder / "*.nc").string() << "\nreport:  " << fs::absolute(page).string() << "\n";
}

}  // namespace ringfilm::app
