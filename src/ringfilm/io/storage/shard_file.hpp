#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ringfilm/study/study_run.hpp"

/// Rows of a study as they are computed, in a file that can be cut off anywhere; docs/manual/study.md.
namespace ringfilm::io {

/// To what rows belong; files whose headers differ must not be mixed.
struct ShardHeader {
  std::string plan;                      ///< SHA-256 of Plan::digest_text()
  std::string inputs;                    ///< SHA-256 of the digests of all input files
  std::string program;                   ///< name, version and commit
  std::uint64_t part = 1, parts = 1;     ///< this is part `part` of `parts`
  std::uint64_t first = 0, end = 0;      ///< its scenarios, without `end`
  std::uint64_t n_values = 0;            ///< number of values of each row
  std::vector<std::string> curves = {};  ///< names of the curves that are kept of each row
  /// Number of angles at which they are kept, evenly spread over the cycle; 0 without curves.
  std::uint64_t n_angles = 0;
  std::string kernels = "any";  ///< name of the film::FilmKernels that computed them

  std::uint64_t n_curve_numbers() const { return curves.size() * n_angles; }
  study::ScenarioRange range() const { return {first, end}; }
};

/// What differs between two headers, in words ("another plan"); empty if the rows found are of what is required.
/// Kernels are not compared: rows that are there may be read wherever they were computed.
std::string difference(const ShardHeader& found, const ShardHeader& expected);

/// Are the rows found the first ones of those expected, of a study in one part that has only become longer?
bool is_beginning_of(const ShardHeader& found, const ShardHeader& expected);

/// Bytes of a file that has no row yet.
std::uint64_t size_without_rows(const ShardHeader& header);

/// Where the intact blocks of a file lie.
struct BlockPlace {
  std::uint64_t first = 0, n_rows = 0;
  std::uint64_t values_at = 0;  ///< values one after the other, each of all rows
  std::uint64_t curves_at = 0;  ///< then, in single precision, curves, angle by angle, each of all rows
  std::uint64_t reasons_at = 0, reasons_size = 0;
  std::uint64_t notes_at = 0, notes_size = 0;  ///< after the reasons
  std::uint64_t n_unsolved = 0;
  std::uint64_t end() const { return first + n_rows; }
};

/// A note that several scenarios carry.
struct SharedNote {
  std::string topic;
  std::string message;                   ///< message of scenario `first`
  std::vector<std::uint64_t> scenarios;  ///< scenarios within the range that was asked for, increasing
  std::uint64_t first = 0;               ///< first of all scenarios that share the note; may lie before the range
};

/// A file of rows that is there. Blocks may come in any order; those after the first that is cut off or corrupted are
/// not read.
class ShardReader {
 public:
  /// Throws InputError if it cannot be read or is not a such file.
  explicit ShardReader(const std::string& path);
  ShardReader(ShardReader&& other) noexcept;
  ShardReader& operator=(ShardReader&&) = delete;
  ~ShardReader();

  const std::string& path() const { return path_; }
  const ShardHeader& header() const { return header_; }
  std::uint64_t next() const { return next_; }  ///< first scenario that is not there
  bool is_complete() const { return next() == header_.end; }
  std::uint64_t n_rows() const;                      ///< all that are there, also beyond next()
  std::vector<study::ScenarioRange> beyond() const;  ///< the scenarios beyond next() that are there
  /// Size of the header, after which the blocks begin [byte].
  std::uint64_t header_bytes() const { return header_bytes_; }
  std::uint64_t intact_bytes() const { return intact_bytes_; }
  bool is_intact() const { return intact_bytes_ == size_; }  ///< is nothing cut off or corrupted?
  std::uint64_t n_unsolved() const { return n_unsolved_; }   ///< number of unsolved scenarios up to next()
  std::uint64_t n_unsolved_rows() const;                     ///< number of unsolved scenarios among n_rows()

  /// Value `i` of these scenarios, all of which must be there.
  void read_values(std::size_t i, const study::ScenarioRange& range, double* to) const;
  /// Curve `i` of these scenarios at some angles: all scenarios at the first of them, then at the next. `stride` from
  /// one angle to the next in `to`.
  void read_curve(std::size_t i, std::size_t first_angle, std::size_t n_angles, const study::ScenarioRange& range,
                  float* to, std::size_t stride) const;
  /// Appends value `i` of all rows, in the order of the scenarios.
  void append_values(std::size_t i, std::vector<double>& all) const;

  struct Unsolved {
    std::uint64_t scenario;
    std::string reason;
  };
  /// Appends the rows that are not solved, all or those among some scenarios.
  void append_unsolved(std::vector<Unsolved>& all) const;
  void append_unsolved(const study::ScenarioRange& range, std::vector<Unsolved>& all) const;
  std::uint64_t reason_bytes() const { return reason_bytes_; }  ///< size of all reasons together [byte]
  /// Appends the notes of some scenarios, block by block and base by base: a topic may come several times. The
  /// messages of a base and block include that of the scenario that study::ScenarioNote::comes_before all others.
  void append_notes(const study::ScenarioRange& range, std::vector<SharedNote>& all) const;

  /// Hands over the bytes of all intact blocks, piece by piece.
  void copy_blocks(const std::function<void(const std::string&)>& put) const;

 private:
  void read_header();
  bool read_block();
  std::string bytes(std::uint64_t at, std::uint64_t n) const;
  void read_bytes(std::uint64_t at, std::uint64_t n, char* to) const;
  /// Blocks that hold some of these scenarios.
  std::span<const BlockPlace> blocks_of(const study::ScenarioRange& range) const;

  std::string path_;
  int file_ = -1;
  std::uint64_t size_ = 0, header_bytes_ = 0, intact_bytes_ = 0, n_unsolved_ = 0, reason_bytes_ = 0;
  ShardHeader header_;
  std::vector<BlockPlace> blocks_;  ///< in the order of their scenarios
  std::size_t n_joined_ = 0;        ///< number of blocks that follow each other from the first scenario
  std::uint64_t next_ = 0;          ///< first scenario after these blocks
};

/// Throws InputError if a process appends to the file of rows now.
void check_not_being_written(const std::string& path);

/// May a study that is there become longer?
enum class Extension { kRefused, kAllowed };

/// What becomes of rows that are there.
enum class Rows { kContinued, kReplaced };

/// Appends blocks to a file that nobody else appends to. What was appended is on the disk, also if the machine stops.
class ShardWriter {
 public:
  /// Begins the file, or continues after the last intact block of the existing one. Where it may become longer and
  /// is_beginning_of the one expected, it is written anew aside, with its rows. Throws InputError if that one belongs
  /// to another study, program, input or other kernels, or if another process appends to it; OutputError. Rows that are
  /// to be replaced are removed once the file is locked, whatever they belong to.
  ShardWriter(const std::string& path, const ShardHeader& header, Extension longer = Extension::kRefused,
              Rows rows = Rows::kContinued);
  ShardWriter(const ShardWriter&) = delete;
  ShardWriter& operator=(const ShardWriter&) = delete;
  ~ShardWriter();

  std::uint64_t next() const { return next_; }              ///< first scenario that is not there
  std::uint64_t n_rows() const { return n_rows_; }          ///< all that are there, also beyond next()
  std::uint64_t n_unsolved() const { return n_unsolved_; }  ///< number of unsolved scenarios among n_rows()
  std::vector<study::ScenarioRange> beyond() const;         ///< the scenarios beyond next() that are there
  /// The block may lie beyond next(). Throws OutputError; the file then ends with the block before.
  void append(const study::ScenarioBlock& block);
  /// Gives the file its final name while nobody else can lock it; throws OutputError.
  void rename(const std::string& to) const;

 private:
  /// Opens the file for this process alone. @returns its size
  std::uint64_t open_alone();
  /// Throws InputError unless the rows that are there can be gone on with.
  void check(const ShardHeader& found, Extension longer) const;
  /// Puts a file with our header and these rows in the place of theirs.
  void write_anew(const ShardReader& there);
  void write(const std::string& bytes);

  std::string path_;
  int file_ = -1;
  ShardHeader header_;
  std::uint64_t next_, length_ = 0, n_rows_ = 0, n_unsolved_ = 0;
  std::map<std::uint64_t, std::uint64_t> beyond_;  ///< from its first scenario the end of each range beyond next_
};

}  // namespace ringfilm::io
