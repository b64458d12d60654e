#pragma once
#include <string>
#include <vector>

#include "ringfilm/io/case/case_entry.hpp"

/// What to cite for the laws and the data of a case.
namespace ringfilm::io {

/// Keys of docs/references.bib, each once: those of data/citations.csv for the choices of the case, in the order of
/// that table, and those that `texts` name, the source of an oil or a pair.
/// @param inputs of a case or a result; those of rings have their number
/// Throws InputError where the shipped folder is not found.
std::vector<std::string> citation_keys(const std::vector<CaseEntry>& inputs, const std::vector<std::string>& texts);

/// The entries of docs/references.bib of those keys after that of the program. @param program name and version
std::string citations_bibtex(const std::vector<std::string>& keys, const std::string& program);

}  // namespace ringfilm::io
