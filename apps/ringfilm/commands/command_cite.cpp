#include <filesystem>
#include <iostream>
#include <string>

#include "command_options.hpp"
#include "commands/commands.hpp"
#include "ringfilm/io/case/case_file.hpp"
#include "ringfilm/io/case/citations.hpp"
#include "ringfilm/io/data/shipped_pairs.hpp"
#include "ringfilm/io/result/result_file.hpp"
#include "ringfilm/io/text/source_text.hpp"

namespace ringfilm::app {
namespace {

constexpr const char* kPairRole = "contact.friction_pair";

struct CiteOptions {
  std::string path;  ///< a case, or a result
};

constexpr const char* kCiteFooter = R"(Examples:
  ringfilm cite result.nc > result.bib
  ringfilm cite case.toml

BibTeX of the laws that the case chooses (data/citations.csv), of a case file also of the sources that its oil and its
comments name (docs/references.bib).
)";

void declare_cite(CommandOptions& add, CiteOptions& options) {
  add.text("FILE", options.path, "", "a case (.toml) or a result (.nc)")->required();
}

void cite(const CiteOptions& options) {
  std::vector<std::string> texts;
  std::vector<io::CaseEntry> inputs;
  std::string program = io::this_program().program;
  if (std::filesystem::path(options.path).extension() == ".nc") {
    const io::ResultDocument result = io::read_result(options.path);
    inputs = result.inputs;
    program = result.provenance.program;
  } else {
    const cycle::Case c = io::read_case(options.path, {});
    inputs = io::case_entries(c);
    for (const auto& file : c.files) {
      if (file.role == kPairRole || std::filesystem::path(file.path).extension() != ".toml") continue;
      const io::NamedFile named = io::locate(file.path, "");
      texts.push_back(io::read_source_text(named.path, named.shown, io::kMaxToml).text);
    }
    const io::Units units;
    for (const io::CaseEntry& entry : inputs) {
      // The file has all pairs: the source of this one counts.
      if (!entry.key.ends_with(kPairRole)) continue;
      texts.push_back(io::pair_of_name(io::shipped_pairs(units), entry.shown).source);
    }
  }
  std::cout << io::citations_bibtex(io::citation_keys(inputs, texts), program);
}

}  // namespace

void add_cite_command(Program& program) {
  program.add("cite", "Print BibTeX of the laws and data of a case or a result", kCiteFooter, declare_cite, cite);
}

}  // namespace ringfilm::app
