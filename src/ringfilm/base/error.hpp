#pragma once
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

/// The kinds of failure. Each maps to one exit code of the program (docs/manual/command-line.md).
namespace ringfilm {

/// Where in the user's text a fault lies. `line` and `column` count from 1; 0 means "the file as a whole".
struct SourceMark {
  std::string file;       ///< as the user named it; "--set" for the command line
  int line = 0;           ///< from 1; 0: the file as a whole
  int column = 0;         ///< column of the first character at fault, from 1; 0: the whole line
  std::string line_text;  ///< the line itself, without its end; empty if not known
};

/// One thing that is wrong with the input: where, what rule was broken with which value, what to write instead.
struct Fault {
  SourceMark mark;      ///< place of the fault; its file name is empty where the fault lies at no place of a file
  std::string message;  ///< value and rule, e.g. "ring.tangential_force = 12.5 has no unit"
  std::string remedy;   ///< next step, e.g. "a force is required here, for example \"12.5 N\""; may be empty
};

/// The input cannot be used (exit code 2). Carries every fault that was found, not only the first.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<Fault> faults);  ///< every fault, in the order in which it was found
  /// One fault that lies at no place of a file.
  explicit InputError(const std::string& message, const std::string& remedy = "");

  const std::vector<Fault>& faults() const noexcept { return faults_; }  ///< all of them, in their order

 private:
  std::vector<Fault> faults_;
};

/// A name was asked for that nothing has; stated where nothing else of the input was looked at yet.
class UnknownKeyError : public InputError {
 public:
  using InputError::InputError;
};

/// No film was found that balances what acts on it, all remedies spent (exit code 3).
class ConvergenceError : public std::runtime_error {
 public:
  explicit ConvergenceError(const std::string& message) : std::runtime_error(message) {}  ///< where no crank turns
  /// @param crank_angle_deg where a cycle stopped [degree], 0 = firing TDC; nothing where no crank turns
  ConvergenceError(const std::string& message, std::optional<double> crank_angle_deg)
      : std::runtime_error(message), crank_angle_deg_(crank_angle_deg) {}

  /// Where a cycle stopped [degree].
  std::optional<double> crank_angle_deg() const noexcept { return crank_angle_deg_; }

 private:
  std::optional<double> crank_angle_deg_;
};

/// A file could not be written; an earlier file is untouched (exit code 5).
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The faults as a person reads them: "file:line:column: message", the line, a caret, the remedy; one after the other,
/// with control characters made visible; the first hundred, and how many there are beyond them.
std::string describe(const std::vector<Fault>& faults);

}  // namespace ringfilm
