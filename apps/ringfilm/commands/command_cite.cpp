#include <filesystem>
#include <iostream>
#include <string>

#include "command_options.hpp"
#include "commands/commands.hpp"
#include "ringfilm/io/case/case_file.hpp"
#include "ringfilm/io/data/citations.hpp"
#include "ringfilm/io/result/result_file.hpp"
#include "ringfilm/io/text/source_text.hpp"

namespace ringfilm::app {
namespace {

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
  std::string resolved, program = io::this_program().program;
  if (std::filesystem::path(options.path).extension() == ".nc") {
    const io::ResultDocument result = io::read_result(options.path);
    resolved = result.resolved_case;
    program = result.provenance.program;
  } else {
    const cycle::Case c = io::read_case(options.path, {});
    resolved = io::resolved_case(c);
    for (const auto& file : c.files) {
      if (std::filesystem::path(file.path).extension() != ".toml") continue;
      texts.push_back(io::read_source_text(file.path, file.path, io::kMaxToml).text);
    }
  }
  std::cout << io::citations_bibtex(io::citation_keys(resolved, texts), program);
}

}  // namespace

void add_cite_command(Program& program) {
  program.add("cite", "Print BibTeX of the laws and data of a case or a result", kCiteFooter, declare_cite, cite);
}

}  // namespace ringfilm::app
