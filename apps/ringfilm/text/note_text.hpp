#pragma once
#include <string>
#include <vector>

#include "ringfilm/io/result/result_file.hpp"

namespace ringfilm::app {

/// Notes of a result or of the rings of a pack, each topic once, the most serious first.
class NoteText {
 public:
  /// @param labels of the rings of a pack, as "ring 2"; one empty label where the result is of one ring
  NoteText(const std::vector<const io::ResultDocument*>& rings, const std::vector<std::string>& labels);

  /// How far the result can be trusted, in a line.
  std::string verdict() const;
  /// The most serious notes that fit into so many lines, and how many more there are.
  std::string most_serious(std::size_t max_lines) const;

 private:
  struct One {
    cycle::Note note;
    std::string label;                ///< ring whose message it is
    std::vector<std::string> others;  ///< rings that have such a note, too
  };
  std::size_t n_rings_;
  std::vector<One> notes_;
};

}  // namespace ringfilm::app
