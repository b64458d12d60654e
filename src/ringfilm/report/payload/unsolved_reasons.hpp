#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace ringfilm::report {

/// Why scenarios were not solved, counted by the words of the reason whatever its numbers are.
class UnsolvedReasons {
 public:
  struct Reason {
    std::string text;  ///< reason of the first scenario
    std::uint64_t count = 0;
    std::uint64_t first = 0;  ///< first scenario that has it
    bool numbers_differ = false;
  };

  void add(std::uint64_t scenario, const std::string& text);

  std::uint64_t count() const { return count_; }  ///< number of scenarios that were added
  /// Those that come after a thousand others are counted together.
  std::vector<Reason> most_frequent_first() const;

 private:
  std::map<std::string, Reason> by_words_;
  std::uint64_t count_ = 0;
};

}  // namespace ringfilm::report
