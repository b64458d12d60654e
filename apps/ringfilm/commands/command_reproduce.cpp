#include <fmt/format.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <utility>
#include <vector>

#include "commands/commands.hpp"
#include "reproduction.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"
#include "ringfilm/io/storage/shipped.hpp"
#include "ringfilm/io/verification/published_file.hpp"
#include "ringfilm/report/html.hpp"
#include "text/shared_options.hpp"

namespace ringfilm::app {
namespace {

namespace fs = std::filesystem;

/// The rings of the publication, in the order of their life.
constexpr std::array kRings = {"new", "run-in", "embedded"};
constexpr const char* kPublication = "styles2014";
constexpr const char* kMeasured = "measured";

/// One ring with what is published of it.
struct RingInput {
  std::string ring;
  cycle::Case input;
  std::vector<study::PublishedValue> published;
};

/// All that is read, before anything is computed or written.
std::vector<RingInput> ring_inputs(const fs::path& cases) {
  const io::Units units;
  std::vector<RingInput> inputs;
  for (const std::string ring : kRings) {
    inputs.push_back({ring, case_for_report((cases / (ring + ".toml")).string(), units),
                      io::read_published((cases / "published.toml").string(), ring, units)});
  }
  return inputs;
}

std::vector<io::ResultDocument> computed_rings(const std::vector<RingInput>& rings, int jobs) {
  std::vector<run::Request> requests;
  for (const RingInput& ring : rings) requests.push_back({ring.input, ring.ring, true, true});
  std::vector<io::ResultDocument> documents = computed(requests, jobs);
  for (std::size_t i = 0; i < rings.size(); ++i) {
    io::ResultDocument& document = documents[i];
    document.comparison = study::compare(document.result, rings[i].published, document.ledger);
  }
  return documents;
}

std::string comparison_table(const std::string& ring, const io::ResultDocument& document) {
  constexpr double kWorthAReason = 0.01;  // a deviation below 1 % is rounding of the published value
  const EngineeringText in_words;
  std::string text = fmt::format("{} ring\n{:>13}{:>24}{:>11}\n", ring, "published", "computed", "deviation");
  for (const study::ComparisonRow& row : document.comparison) {
    const study::PublishedValue& published = row.published;
    text += fmt::format("{:>13}{:>24}{:>+9.1f} %   {} ({})\n", in_words(published.quantity, published.value),
                        in_words(published.quantity, row.computed, error_of(document, published.quantity)),
                        100 * row.deviation, published.statement, published.source);
    if (row.with_strongest_setting && std::abs(row.deviation) > kWorthAReason) {
      text += fmt::format("{:>51}{} with {}\n", "", in_words(published.quantity, *row.with_strongest_setting),
                          row.strongest_setting);
    }
  }
  return text;
}

/// The rings side by side, for what the paper states in words.
std::string rings_table(const std::vector<io::ResultDocument>& documents) {
  const EngineeringText in_words;
  std::string text = fmt::format("{:<42}", "the three rings");
  for (const std::string ring : kRings) text += fmt::format("{:>24}", ring);
  text += "\n";
  for (const char* name : {"min_film_thickness", "peak_friction_coefficient_firing", "mean_power_loss",
                           "mean_boundary_power", "mean_absolute_oil_flow"}) {
    text += fmt::format("{:<42}{}\n", name, cells(name, documents, in_words));
  }
  return text +
         "the paper in words: friction falls with wear, boundary friction dominates near firing TDC, the embedded\n"
         "ring passes clearly more oil, the new ring has the thinnest film near TDC (its numbers state the thickest)\n";
}

void reproduce(const ReproduceOptions& options) {
  if (options.publication == kMeasured) return reproduce_measured(options);
  if (options.publication != kPublication) {
    throw InputError("no publication is called " + options.publication,
                     fmt::format("known: {}, and {}: the same from files of instruments", kPublication, kMeasured));
  }
  const fs::path folder = options.folder.empty() ? fs::path(kPublication) : fs::path(options.folder);
  const fs::path cases = fs::path(io::shipped_folder()) / "cases" / kPublication;
  const std::vector<RingInput> inputs = ring_inputs(cases);
  const std::string page = (folder / "report.html").string();
  const io::OutputClaim claimed = claimed_report(page);

  std::cout << "Styles et al. 2014: three rings over one engine cycle at 1500 rpm and 120 degC\n"
            << "cylinder pressure: SYNTHETIC, made for this project; the paper's own trace is only a picture\n\n";
  const std::vector<io::ResultDocument> documents = computed_rings(inputs, options.jobs);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    io::write_result((folder / (inputs[i].ring + ".nc")).string(), documents[i]);
    std::cout << comparison_table(inputs[i].ring, documents[i]) << "\n";
  }
  std::cout << rings_table(documents) << "\n";
  io::write_atomically(page, ringfilm::report::report_page(documents, {}));
  std::cout << "results: " << (folder / "*.nc").string() << "\nreport:  " << fs::absolute(page).string() << "\n";
}

constexpr const char* kReproduceFooter = R"(Examples:
  ringfilm reproduce styles2014
  ringfilm reproduce styles2014 --output paper
  ringfilm reproduce measured --output measured
)";

void declare_reproduce(CommandOptions& add, ReproduceOptions& options) {
  add.text("publication", options.publication, "",
           "styles2014: three rings, new, run-in and embedded; measured: the same from files of instruments")
      ->required();
  add.text("-o,--output", options.folder, "DIR", "folder for results and report (default ./<publication>)");
  add.flag("--friction-band", options.bands, FrictionBands::kComputed,
           "of measured: press the maps against each other, and compute film and friction with each law");
  add_jobs(add, options.jobs);
}

}  // namespace

void add_reproduce_command(Program& program) {
  program.add("reproduce", "Compute a publication anew and compare with it", kReproduceFooter, declare_reproduce,
              reproduce);
}

}  // namespace ringfilm::app
