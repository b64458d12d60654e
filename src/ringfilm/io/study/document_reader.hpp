#pragma once
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "ringfilm/case/case.hpp"
#include "ringfilm/io/text/document_kind.hpp"
#include "ringfilm/io/text/toml_tree.hpp"
#include "ringfilm/io/text/units.hpp"

namespace ringfilm::io {

/// Adds the faults of a case that another file names; those at no place of a file are at `mark`, which names it.
void append_case_faults(const InputError& error, const SourceMark& mark, std::vector<Fault>& faults);

/// What readers of files that name cases have in common: the file, what is wrong with it, and every file that was read.
class DocumentReader {
 protected:
  explicit DocumentReader(const std::string& path);
  DocumentReader(const std::string& path, const std::string& folder);

  /// The file itself as a tree; throws InputError for a file of another kind. @param role role of the cycle::InputFile
  TomlValue read_document(DocumentKind kind, const std::string& role);

  void record(const cycle::InputFile& file);  ///< once
  void record(const cycle::Case& input);      ///< the files that it was read from

  /// Its name without folder and suffix.
  std::string stem() const;

  /// Refuses a pad and a pack of rings. @param document "a life" @returns whether it is of one ring
  bool is_one_ring(const cycle::Case& input, const std::string& path, const std::string& document,
                   const SourceMark& mark);

  std::string path_, folder_;  ///< path of the file; folder that file names in it are relative to
  Units units_;
  std::vector<Fault> faults_;
  std::vector<cycle::InputFile> files_;

 private:
  std::set<std::string> recorded_;
};

}  // namespace ringfilm::io
