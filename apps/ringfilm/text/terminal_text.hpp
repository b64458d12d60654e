#pragma once
#include <iostream>
#include <streambuf>
#include <string_view>

namespace ringfilm::app {

/// Passes text on with its control characters made visible, see printable().
class PrintableBuffer : public std::streambuf {
 public:
  explicit PrintableBuffer(std::streambuf& to) : to_(to) {}

  /// Passes on what the program itself prints to a terminal.
  void put_unchanged(std::string_view text);

 protected:
  int_type overflow(int_type character) override;
  std::streamsize xsputn(const char* text, std::streamsize n) override;
  int sync() override { return to_.pubsync(); }

 private:
  std::streambuf& to_;
};

/// While it lives, texts from files and arguments reach neither standard output nor standard error with control
/// characters in them: a title could command the terminal.
class PrintableStreams {
 public:
  PrintableStreams() : out_(*std::cout.rdbuf()), err_(*std::cerr.rdbuf()) { exchange(); }
  PrintableStreams(const PrintableStreams&) = delete;
  PrintableStreams& operator=(const PrintableStreams&) = delete;
  ~PrintableStreams() { exchange(); }

 private:
  void exchange() {
    before_out_ = std::cout.rdbuf(before_out_);
    before_err_ = std::cerr.rdbuf(before_err_);
  }

  PrintableBuffer out_, err_;
  std::streambuf *before_out_ = &out_, *before_err_ = &err_;
};

/// A command for the terminal, such as to erase a line, to a stream that may be printable.
void command_terminal(std::ostream& stream, std::string_view command);

}  // namespace ringfilm::app
