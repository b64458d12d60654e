#include "ringfilm/io/text/toml_scan.hpp"

#include <algorithm>
#include <string_view>

namespace ringfilm::io {
namespace {

constexpr int kDeepest = 32;

/// Walks the text outside of comments and strings.
class Scanner {
 public:
  explicit Scanner(const SourceText& source) : source_(source), text_(source.text) {}

  void scan() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '#') {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else if (c == '"' || c == '\'') {
        skip_string(c);
      } else {
        look_at(c);
        advance(1);
      }
    }
  }

 private:
  void look_at(char c) {
    if (static_cast<unsigned char>(c) >= 0x80) {
      refuse("a key must be written in ASCII letters", "only text in quotes and comments may hold other letters");
    }
    if (c == '[' || c == '{') ++brackets_;
    if (c == ']' || c == '}') --brackets_;
    if (c == '.') ++dots_;
    if (c == '\n' || c == ',' || c == '=') dots_ = 0;
    if (brackets_ > kDeepest || dots_ > kDeepest) refuse("the nesting is deeper than any case file", "");
  }

  void skip_string(char quote) {
    const std::string three(3, quote);
    const bool multi_line = text_.compare(at_, 3, three) == 0;
    advance(multi_line ? 3 : 1);
    while (at_ < text_.size()) {
      if (text_[at_] == '\\' && quote == '"') {
        advance(2);
      } else if (multi_line ? text_.compare(at_, 3, three) == 0 : text_[at_] == quote) {
        advance(multi_line ? 3 : 1);
        return;
      } else if (!multi_line && text_[at_] == '\n') {
        return;  // the parser will report that the quote is missing
      } else {
        advance(1);
      }
    }
  }

  void advance(std::size_t n) {
    for (std::size_t i = 0; i < n && at_ < text_.size(); ++i, ++at_) {
      ++column_;
      if (text_[at_] == '\n') {
        ++line_;
        column_ = 1;
      }
    }
  }

  [[noreturn]] void refuse(const std::string& message, const std::string& remedy) const {
    throw InputError(std::vector<Fault>{{source_.mark(line_, column_), message, remedy}});
  }

  const SourceText& source_;
  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1, column_ = 1;
  int brackets_ = 0, dots_ = 0;
};

}  // namespace

void check_before_parsing(const SourceText& source) { Scanner(source).scan(); }

}  // namespace ringfilm::io
