#include "ringfilm/io/storage/shard_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <tuple>
#include <utility>

#include "ringfilm/cycle/advice/note_topics.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"
#include "ringfilm/io/storage/digest.hpp"
#include "ringfilm/study/design/kept_curves.hpp"
#include "ringfilm/study/scenario_note.hpp"

namespace ringfilm::io {
namespace {

// Blocks, one after the other: the size of the content, its SHA-256 in hexadecimal digits, the content. The first is
// the header as text; each other begins with first scenario, number of rows and bytes of the notes, then values,
// curves, reasons as lines, notes as lines. Numbers are little-endian: values of 8 bytes, those of curves of 4.
constexpr std::uint64_t kDigits = 64, kFrame = 8 + kDigits, kBlockHead = 24;
constexpr std::uint64_t kMaxHeader = 1 << 16, kMaxBlock = std::uint64_t{1} << 30;
constexpr std::string_view kHexDigits = "0123456789abcdef";
constexpr const char* kMagic = "ringfilm study rows 4";
/// Characters of it that files of all versions have.
constexpr std::size_t kMagicStart = std::string_view("ringfilm study rows").size();

/// Characters of the two that are the same at the same place.
std::size_t n_equal(std::string_view a, std::string_view b) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) n += a[i] == b[i] ? 1 : 0;
  return n;
}

std::string number_bytes(std::uint64_t number) {
  std::string bytes(8, '\0');
  for (int i = 0; i < 8; ++i) bytes[i] = static_cast<char>(number >> (8 * i) & 0xff);
  return bytes;
}

std::uint64_t number_at(const std::string& bytes, std::size_t at) {
  std::uint64_t number = 0;
  for (int i = 8; i-- > 0;) number = number << 8 | static_cast<unsigned char>(bytes.at(at + i));
  return number;
}

std::string framed(const std::string& content) { return number_bytes(content.size()) + sha256(content) + content; }

template <class Bits>
Bits swapped_on_big_endian(Bits bits) {
  if constexpr (std::endian::native == std::endian::little) return bits;
  Bits swapped = 0;
  for (std::size_t i = 0; i < sizeof bits; ++i) swapped |= ((bits >> (8 * i)) & 0xff) << (8 * (sizeof bits - 1 - i));
  return swapped;
}

void append_number(std::string& bytes, double number) {
  const auto bits = swapped_on_big_endian(std::bit_cast<std::uint64_t>(number));
  bytes.append(reinterpret_cast<const char*>(&bits), sizeof bits);
}

void append_number(std::string& bytes, float number) {
  const auto bits = swapped_on_big_endian(std::bit_cast<std::uint32_t>(number));
  bytes.append(reinterpret_cast<const char*>(&bits), sizeof bits);
}

void numbers_of(const char* bytes, std::size_t n, double* to) {
  for (std::size_t k = 0; k < n; ++k) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, bytes + k * sizeof bits, sizeof bits);
    to[k] = std::bit_cast<double>(swapped_on_big_endian(bits));
  }
}

void numbers_of(const char* bytes, std::size_t n, float* to) {
  for (std::size_t k = 0; k < n; ++k) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, bytes + k * sizeof bits, sizeof bits);
    to[k] = std::bit_cast<float>(swapped_on_big_endian(bits));
  }
}

std::string text_of(const ShardHeader& h) {
  return fmt::format(
      "{}\nplan {}\ninputs {}\npart {} {}\nrange {} {}\nvalues {}\ncurves {} {} {}\nkernels {}\nprogram {}\n", kMagic,
      h.plan, h.inputs, h.part, h.parts, h.first, h.end, h.n_values, h.n_angles, h.curves.size(),
      fmt::join(h.curves, " "), h.kernels, h.program);
}

/// Bytes of the numbers of a row.
std::uint64_t row_bytes(const ShardHeader& h) {
  return sizeof(double) * h.n_values + sizeof(float) * h.n_curve_numbers();
}

std::string in_one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

/// Lines of a topic, the rows of the block that carry it as bits in hexadecimal digits, and the message of the first of
/// them. Each base and topic has one line for the row to show and one for all others; the most serious topics first.
std::string note_lines(const study::ScenarioBlock& block) {
  using Key = std::tuple<std::size_t, std::string, std::size_t>;  // order of the topic, topic, base
  std::map<Key, std::vector<study::ScenarioNote>> carriers;
  for (std::size_t k = 0; k < block.rows.size(); ++k) {
    const study::ScenarioRow& row = block.rows[k];
    for (const cycle::Note& note : row.notes) {
      carriers[{cycle::note_rank(note.topic), note.topic, row.base}].push_back(
          {k, note.message, block.has_cycle ? cycle::note_badness(note.topic, row.values) : std::nullopt});
    }
  }
  std::string lines;
  const auto append_line = [&](const std::string& topic, std::span<const study::ScenarioNote> notes) {
    if (notes.empty()) return;
    std::vector<unsigned> digits((block.rows.size() + 3) / 4);
    for (const study::ScenarioNote& note : notes) digits[note.scenario / 4] |= 1U << (note.scenario % 4);
    lines += fmt::format("{} {:x} {}\n", topic, fmt::join(digits, ""), in_one_line(notes.front().message));
  };
  for (auto& [key, notes] : carriers) {
    const auto shown =
        std::min_element(notes.begin(), notes.end(), [](const auto& a, const auto& b) { return a.comes_before(b); });
    if (shown == notes.begin()) {
      append_line(std::get<1>(key), notes);
      continue;
    }
    const study::ScenarioNote one = *shown;
    notes.erase(shown);
    append_line(std::get<1>(key), {&one, 1});
    append_line(std::get<1>(key), notes);
  }
  return lines;
}

std::string content_of(const study::ScenarioBlock& block, const ShardHeader& header) {
  const std::string notes = note_lines(block);
  std::string content = number_bytes(block.first) + number_bytes(block.rows.size()) + number_bytes(notes.size());
  content.reserve(content.size() + row_bytes(header) * block.rows.size());
  for (std::uint64_t i = 0; i < header.n_values; ++i) {
    for (const study::ScenarioRow& row : block.rows) append_number(content, row.values.at(i));
  }
  for (std::uint64_t i = 0; i < header.n_curve_numbers(); ++i) {
    for (const study::ScenarioRow& row : block.rows) append_number(content, row.curves.at(i));
  }
  for (std::size_t k = 0; k < block.rows.size(); ++k) {
    if (block.rows[k].reason.empty()) continue;
    content += fmt::format("{} {}\n", block.first + k, in_one_line(block.rows[k].reason));
  }
  return content + notes;
}

InputError being_written(const std::string& path) {
  return InputError(fmt::format("{}: another process computes this part now", path),
                    "wait for it, stop it first, or name another output");
}

/// Takes the lock of a writer. check_not_being_written() holds it for a moment.
/// @returns false where another process holds it  @param path in messages
bool take_lock(int file, const std::string& path) {
  constexpr int kTries = 20;
  constexpr useconds_t kPause = 10'000;  // [us]
  for (int n = 0; n < kTries;) {
    if (::flock(file, LOCK_EX | LOCK_NB) == 0) return true;
    switch (errno) {
      case EINTR:
        break;
      case EWOULDBLOCK:
        ++n;
        ::usleep(kPause);
        break;
      case ENOTSUP:
      case ENOSYS:
      case EINVAL:
      case ENOLCK:
        return true;  // not every file system has locks
      default:
        fail_to_write(path, errno);
    }
  }
  return false;
}

}  // namespace

std::string difference(const ShardHeader& found, const ShardHeader& expected) {
  if (found.program != expected.program) return fmt::format("another version of the program, {}", found.program);
  // A plan contains the digests of its bases, so that changed files would pass for another plan.
  if (found.inputs != expected.inputs) return "other input files, or such as have changed since";
  if (found.plan != expected.plan) return "another plan: bases, factors, method or seed";
  if (found.curves != expected.curves || found.n_angles != expected.n_angles) return "other curves: keep has changed";
  if (found.n_values != expected.n_values) return "other values";
  if (found.part != expected.part || found.parts != expected.parts)
    return fmt::format("part {} of {}", found.part, found.parts);
  return found.first != expected.first || found.end != expected.end ? "another number of scenarios" : "";
}

bool is_beginning_of(const ShardHeader& found, const ShardHeader& expected) {
  ShardHeader longer = found;
  longer.end = expected.end;
  return found.parts == 1 && found.end < expected.end && difference(longer, expected).empty();
}

std::uint64_t size_without_rows(const ShardHeader& header) { return kFrame + text_of(header).size(); }

ShardReader::ShardReader(const std::string& path) : path_(path), file_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
  struct stat status {};
  if (file_ < 0 || ::fstat(file_, &status) != 0) {
    throw InputError(fmt::format("{}: could not be read: {}", path, std::strerror(errno)));
  }
  size_ = static_cast<std::uint64_t>(status.st_size);
  try {
    read_header();
    while (read_block()) {
    }
  } catch (...) {
    ::close(file_);
    throw;
  }
}

ShardReader::ShardReader(ShardReader&& other) noexcept
    : path_(std::move(other.path_)),
      file_(std::exchange(other.file_, -1)),
      size_(other.size_),
      header_bytes_(other.header_bytes_),
      intact_bytes_(other.intact_bytes_),
      n_unsolved_(other.n_unsolved_),
      reason_bytes_(other.reason_bytes_),
      header_(std::move(other.header_)),
      blocks_(std::move(other.blocks_)),
      n_joined_(other.n_joined_),
      next_(other.next_) {}

ShardReader::~ShardReader() {
  if (file_ >= 0) ::close(file_);
}

std::uint64_t ShardReader::n_rows() const {
  return std::accumulate(blocks_.begin(), blocks_.end(), std::uint64_t{0},
                         [](std::uint64_t n, const BlockPlace& block) { return n + block.n_rows; });
}

std::uint64_t ShardReader::n_unsolved_rows() const {
  return std::accumulate(blocks_.begin(), blocks_.end(), std::uint64_t{0},
                         [](std::uint64_t n, const BlockPlace& block) { return n + block.n_unsolved; });
}

std::vector<study::ScenarioRange> ShardReader::beyond() const {
  std::vector<study::ScenarioRange> ranges;
  for (const BlockPlace& block : std::span(blocks_).subspan(n_joined_)) {
    if (ranges.empty() || ranges.back().end != block.first) ranges.push_back({block.first, block.first});
    ranges.back().end = block.end();
  }
  return ranges;
}

void ShardReader::read_bytes(std::uint64_t at, std::uint64_t n, char* to) const {
  std::uint64_t done = 0;
  while (done < n) {
    const ssize_t got = ::pread(file_, to + done, n - done, static_cast<off_t>(at + done));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) throw InputError(fmt::format("{}: could not be read to its end", path_));
    done += static_cast<std::uint64_t>(got);
  }
}

std::string ShardReader::bytes(std::uint64_t at, std::uint64_t n) const {
  std::string all(n, '\0');
  read_bytes(at, n, all.data());
  return all;
}

void ShardReader::copy_blocks(const std::function<void(const std::string&)>& put) const {
  constexpr std::uint64_t kPiece = 1 << 20;
  for (std::uint64_t at = header_bytes_; at < intact_bytes_; at += kPiece)
    put(bytes(at, std::min(kPiece, intact_bytes_ - at)));
}

void ShardReader::read_header() {
  const InputError no_such_file(fmt::format("{}: this is not a file of rows of a study, or it was cut off", path_),
                                "delete it to begin anew");
  const InputError damage(
      fmt::format("{}: the header of this file of rows is corrupted, so that its rows cannot be assigned to a study",
                  path_),
      "take the file from a copy, or delete it to compute its rows again");
  if (size_ < kFrame) throw no_such_file;
  // Where the size itself is corrupted, the header is still where it was.
  const std::string_view magic_start = std::string_view(kMagic).substr(0, kMagicStart);
  const std::string start = bytes(kFrame, std::min<std::uint64_t>(magic_start.size(), size_ - kFrame));
  const InputError& refusal = n_equal(start, magic_start) + 1 >= magic_start.size() ? damage : no_such_file;
  const std::uint64_t n = number_at(bytes(0, 8), 0);
  if (n > kMaxHeader || n > size_ - kFrame) throw refusal;
  const std::string text = bytes(kFrame, n);
  if (sha256(text) != bytes(8, kDigits)) throw refusal;
  std::istringstream lines(text);
  std::string magic, word;
  ShardHeader& h = header_;
  std::getline(lines, magic);
  lines >> word >> h.plan >> word >> h.inputs >> word >> h.part >> h.parts >> word >> h.first >> h.end >> word >>
      h.n_values >> word;
  std::uint64_t n_curves = 0;
  lines >> h.n_angles >> n_curves;
  constexpr std::uint64_t kMaxCurves = 1000;
  if (!lines || n_curves > kMaxCurves) throw no_such_file;
  h.curves.resize(n_curves);
  for (std::string& name : h.curves) lines >> name;
  lines >> word >> h.kernels >> word;
  std::getline(lines >> std::ws, h.program);
  constexpr std::uint64_t kMaxValues = 10'000;
  if (magic != kMagic || !lines || h.first > h.end || h.n_values == 0 || h.n_values > kMaxValues ||
      h.n_angles > study::kMaxCurveNumbers || h.n_curve_numbers() > study::kMaxCurveNumbers) {
    throw no_such_file;
  }
  header_bytes_ = intact_bytes_ = kFrame + n;
  next_ = h.first;
}

bool ShardReader::read_block() {
  if (size_ - intact_bytes_ < kFrame) return false;
  const std::string frame = bytes(intact_bytes_, kFrame);
  const std::uint64_t n = number_at(frame, 0);
  if (n < kBlockHead || n > kMaxBlock || n > size_ - intact_bytes_ - kFrame) return false;
  const std::string content = bytes(intact_bytes_ + kFrame, n);
  if (sha256(content) != frame.substr(8)) return false;
  BlockPlace place;
  place.first = number_at(content, 0);
  place.n_rows = number_at(content, 8);
  place.notes_size = number_at(content, 16);
  const std::uint64_t most_rows = (n - kBlockHead) / row_bytes(header_);
  const auto later = std::partition_point(blocks_.begin() + static_cast<std::ptrdiff_t>(n_joined_), blocks_.end(),
                                          [&](const BlockPlace& block) { return block.first < place.first; });
  const std::uint64_t lowest = later == blocks_.begin() ? header_.first : std::prev(later)->end();
  const std::uint64_t highest = later == blocks_.end() ? header_.end : later->first;
  if (place.first < lowest || place.first >= highest || place.n_rows == 0 || place.n_rows > most_rows ||
      place.n_rows > highest - place.first) {
    return false;
  }
  const std::uint64_t n_bytes = row_bytes(header_) * place.n_rows;
  if (place.notes_size > n - kBlockHead - n_bytes) return false;
  place.values_at = intact_bytes_ + kFrame + kBlockHead;
  place.curves_at = place.values_at + sizeof(double) * header_.n_values * place.n_rows;
  place.reasons_at = place.values_at + n_bytes;
  place.reasons_size = n - kBlockHead - n_bytes - place.notes_size;
  place.notes_at = place.reasons_at + place.reasons_size;
  reason_bytes_ += place.reasons_size;
  const std::string_view reasons = std::string_view(content).substr(kBlockHead + n_bytes, place.reasons_size);
  place.n_unsolved = static_cast<std::uint64_t>(std::count(reasons.begin(), reasons.end(), '\n'));
  blocks_.insert(later, place);
  for (; n_joined_ < blocks_.size() && blocks_[n_joined_].first == next_; ++n_joined_) {
    next_ = blocks_[n_joined_].end();
    n_unsolved_ += blocks_[n_joined_].n_unsolved;
  }
  intact_bytes_ += kFrame + n;
  return true;
}

std::span<const BlockPlace> ShardReader::blocks_of(const study::ScenarioRange& range) const {
  if (range.first < header_.first || range.end > next()) {
    throw std::out_of_range(fmt::format("{}: scenarios {} to {} are not there", path_, range.first, range.end));
  }
  const auto begin = std::partition_point(blocks_.begin(), blocks_.end(),
                                          [&](const BlockPlace& block) { return block.end() <= range.first; });
  const auto end =
      std::partition_point(begin, blocks_.end(), [&](const BlockPlace& block) { return block.first < range.end; });
  return {begin, end};
}

void ShardReader::read_values(std::size_t i, const study::ScenarioRange& range, double* to) const {
  std::string raw;
  for (const BlockPlace& block : blocks_of(range)) {
    const std::uint64_t begin = std::max(block.first, range.first);
    const std::uint64_t n = std::min(block.first + block.n_rows, range.end) - begin;
    raw.resize(sizeof(double) * n);
    read_bytes(block.values_at + sizeof(double) * (i * block.n_rows + begin - block.first), raw.size(), raw.data());
    numbers_of(raw.data(), n, to + (begin - range.first));
  }
}

void ShardReader::read_curve(std::size_t i, std::size_t first_angle, std::size_t n_angles,
                             const study::ScenarioRange& range, float* to, std::size_t stride) const {
  if (i >= header_.curves.size() || first_angle + n_angles > header_.n_angles) {
    throw std::out_of_range(fmt::format("{}: curve {} at angle {} is not there", path_, i, first_angle));
  }
  std::string raw;
  for (const BlockPlace& block : blocks_of(range)) {
    const std::uint64_t begin = std::max(block.first, range.first);
    const std::uint64_t n = std::min(block.first + block.n_rows, range.end) - begin;
    raw.resize(sizeof(float) * n_angles * block.n_rows);
    read_bytes(block.curves_at + sizeof(float) * (i * header_.n_angles + first_angle) * block.n_rows, raw.size(),
               raw.data());
    for (std::size_t k = 0; k < n_angles; ++k) {
      const std::uint64_t at = k * block.n_rows + (begin - block.first);
      numbers_of(raw.data() + sizeof(float) * at, n, to + k * stride + (begin - range.first));
    }
  }
}

void ShardReader::append_values(std::size_t i, std::vector<double>& all) const {
  const study::ScenarioRange range{header_.first, next()};
  all.resize(all.size() + range.size());
  read_values(i, range, all.data() + (all.size() - range.size()));
}

void ShardReader::append_unsolved(const study::ScenarioRange& range, std::vector<Unsolved>& all) const {
  for (const BlockPlace& block : blocks_of(range)) {
    if (block.reasons_size == 0) continue;
    std::istringstream lines(bytes(block.reasons_at, block.reasons_size));
    Unsolved one{};
    while (lines >> one.scenario && std::getline(lines >> std::ws, one.reason)) {
      if (one.scenario >= range.first && one.scenario < range.end) all.push_back(one);
    }
  }
}

void ShardReader::append_unsolved(std::vector<Unsolved>& all) const { append_unsolved({header_.first, next()}, all); }

void ShardReader::append_notes(const study::ScenarioRange& range, std::vector<SharedNote>& all) const {
  for (const BlockPlace& block : blocks_of(range)) {
    std::istringstream lines(bytes(block.notes_at, block.notes_size));
    SharedNote one;
    for (std::string digits; lines >> one.topic >> digits && std::getline(lines >> std::ws, one.message);) {
      one.scenarios.clear();
      std::optional<std::uint64_t> first;
      for (std::uint64_t k = 0; k < std::min<std::uint64_t>(block.n_rows, 4 * digits.size()); ++k) {
        const std::size_t digit = kHexDigits.find(digits[k / 4]);
        const std::uint64_t i = block.first + k;
        const bool is_set = digit != std::string_view::npos && (digit >> (k % 4) & 1) != 0;
        if (is_set && !first) first = i;
        if (is_set && i >= range.first && i < range.end) one.scenarios.push_back(i);
      }
      one.first = first.value_or(block.first);
      if (!one.scenarios.empty()) all.push_back(one);
    }
  }
}

ShardWriter::ShardWriter(const std::string& path, const ShardHeader& header, Extension longer, Rows rows)
    : path_(path), header_(header), next_(header.first) {
  try {
    const std::uint64_t found = open_alone();
    const std::uint64_t size = rows == Rows::kReplaced ? 0 : found;
    // A header that was cut off contains nothing; the rest of one that is there decides.
    if (size < size_without_rows(header)) {
      if (::ftruncate(file_, 0) != 0) fail_to_write(path, errno);
      write(framed(text_of(header)));
      return;
    }
    std::optional<ShardReader> there(path);
    check(there->header(), longer);
    if (there->header().end != header.end) {
      write_anew(*there);
      open_alone();
      there.emplace(path);
      check(there->header(), Extension::kRefused);
    }
    next_ = there->next();
    n_rows_ = there->n_rows();
    n_unsolved_ = there->n_unsolved_rows();
    for (const study::ScenarioRange& range : there->beyond()) beyond_.emplace(range.first, range.end);
    length_ = there->intact_bytes();
    if (::ftruncate(file_, static_cast<off_t>(length_)) != 0) fail_to_write(path, errno);
  } catch (...) {
    if (file_ >= 0) ::close(file_);
    throw;
  }
}

void check_not_being_written(const std::string& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return;
  const bool is_locked = ::flock(file, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(file);
  if (is_locked) throw being_written(path);
}

std::uint64_t ShardWriter::open_alone() {
  if (file_ >= 0) ::close(file_);
  constexpr mode_t kReadWriteAsUmaskAllows = 0666;
  file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, kReadWriteAsUmaskAllows);
  if (file_ < 0) fail_to_write(path_, errno);
  if (!take_lock(file_, path_)) throw being_written(path_);
  struct stat status {};
  if (::fstat(file_, &status) != 0) fail_to_write(path_, errno);
  struct stat named {};
  if (::stat(path_.c_str(), &named) != 0 || named.st_ino != status.st_ino || named.st_dev != status.st_dev) {
    // Its last owner gave it its final name, or put a longer one in its place, between the opening and the lock.
    throw InputError(fmt::format("{}: another process has just finished this part", path_),
                     "start again, with --resume");
  }
  return static_cast<std::uint64_t>(status.st_size);
}

void ShardWriter::check(const ShardHeader& found, Extension longer) const {
  const std::string differs = difference(found, header_);
  if (!differs.empty() && !(longer == Extension::kAllowed && is_beginning_of(found, header_))) {
    throw InputError(fmt::format("{}: these rows are of {}", path_, differs),
                     "results of both must not be mixed: name another output, or replace it with --overwrite");
  }
  if (found.kernels != header_.kernels) {
    throw InputError(fmt::format("{}: these rows were computed with the kernels {}, not with {}", path_, found.kernels,
                                 header_.kernels),
                     fmt::format("both round differently: continue with RINGFILM_KERNELS={}, or name another output",
                                 found.kernels));
  }
}

void ShardWriter::write_anew(const ShardReader& there) {
  AsideFile aside(path_);
  {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(aside.path().c_str(), "wb"), &std::fclose);
    if (file == nullptr) fail_to_write(path_, errno);
    const auto put = [&](const std::string& bytes) {
      if (std::fwrite(bytes.data(), 1, bytes.size(), file.get()) != bytes.size()) fail_to_write(path_, errno);
    };
    put(framed(text_of(header_)));
    there.copy_blocks(put);
    if (std::fflush(file.get()) != 0) fail_to_write(path_, errno);
  }
  aside.put_in_place();
}

ShardWriter::~ShardWriter() { ::close(file_); }

void ShardWriter::append(const study::ScenarioBlock& block) {
  write(framed(content_of(block, header_)));
  beyond_.emplace(block.first, block.first + block.rows.size());
  for (auto range = beyond_.find(next_); range != beyond_.end(); range = beyond_.find(next_))
    next_ = beyond_.extract(range).mapped();
  n_rows_ += block.rows.size();
  for (const study::ScenarioRow& row : block.rows) n_unsolved_ += row.reason.empty() ? 0 : 1;
}

std::vector<study::ScenarioRange> ShardWriter::beyond() const {
  std::vector<study::ScenarioRange> ranges;
  for (const auto& [first, end] : beyond_) ranges.push_back({first, end});
  return ranges;
}

void ShardWriter::rename(const std::string& to) const {
  if (std::rename(path_.c_str(), to.c_str()) != 0) fail_to_write(to, errno);
}

void ShardWriter::write(const std::string& bytes) {
  std::size_t done = 0;
  int error = 0;
  while (done < bytes.size() && error == 0) {
    const ssize_t n = ::pwrite(file_, bytes.data() + done, bytes.size() - done, static_cast<off_t>(length_ + done));
    if (n >= 0) done += static_cast<std::size_t>(n);
    if (n < 0 && errno != EINTR) error = errno;
  }
  if (error == 0 && ::fdatasync(file_) != 0 && errno != EINVAL) error = errno;
  if (error != 0) {
    // What was not written in full would be omitted by readers anyhow.
    [[maybe_unused]] const int ignored = ::ftruncate(file_, static_cast<off_t>(length_));
    throw OutputError(path_ + ": could not be written: " + std::strerror(error) +
                      (length_ > 0 ? " (the rows written before are kept)" : " (it holds no rows)"));
  }
  length_ += bytes.size();
}

}  // namespace ringfilm::io
