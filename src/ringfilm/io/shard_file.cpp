#include "ringfilm/io/shard_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <sstream>
#include <utility>

#include "ringfilm/io/atomic_file.hpp"
#include "ringfilm/io/digest.hpp"

namespace ringfilm::io {
namespace {

// Blocks, one after the other: the size of the content, its SHA-256 in hexadecimal digits, the content. The first is
// the header as text; each other begins with first scenario and number of rows, then values, then reasons as lines.
constexpr std::uint64_t kDigits = 64, kFrame = 8 + kDigits, kChunkHead = 16;
constexpr std::uint64_t kLargestHeader = 1 << 16, kLargestBlock = std::uint64_t{1} << 30;
constexpr const char* kMagic = "ringfilm study rows 1";

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

std::string block(const std::string& content) { return number_bytes(content.size()) + sha256(content) + content; }

std::string text_of(const ShardHeader& h) {
  return fmt::format("{}\nplan {}\ninputs {}\npart {} {}\nrange {} {}\nvalues {}\nprogram {}\n", kMagic, h.plan,
                     h.inputs, h.part, h.parts, h.first, h.end, h.n_values, h.program);
}

std::string content_of(const study::ScenarioChunk& chunk, std::uint64_t n_values) {
  std::string content = number_bytes(chunk.first) + number_bytes(chunk.rows.size());
  for (std::uint64_t i = 0; i < n_values; ++i) {
    for (const study::ScenarioRow& row : chunk.rows) {
      std::uint64_t bits = 0;
      std::memcpy(&bits, &row.values.at(i), sizeof bits);
      content += number_bytes(bits);
    }
  }
  for (std::size_t k = 0; k < chunk.rows.size(); ++k) {
    if (chunk.rows[k].reason.empty()) continue;
    std::string reason = chunk.rows[k].reason;
    for (char& c : reason) c = c == '\n' ? ' ' : c;
    content += fmt::format("{} {}\n", chunk.first + k, reason);
  }
  return content;
}

}  // namespace

std::string difference(const ShardHeader& found, const ShardHeader& wanted) {
  if (found.program != wanted.program) return fmt::format("another version of the program, {}", found.program);
  // A plan knows the digests of its bases, so that changed files would pass for another plan.
  if (found.inputs != wanted.inputs) return "other input files, or such as have changed since";
  if (found.plan != wanted.plan) return "another plan: bases, factors, method or seed";
  if (found.n_values != wanted.n_values) return "other values";
  const bool is_same_part = found.part == wanted.part && found.parts == wanted.parts;
  const bool has_same_range = found.first == wanted.first && found.end == wanted.end;
  return is_same_part && !has_same_range ? "another number of scenarios" : "";
}

ShardReader::ShardReader(const std::string& path) : path_(path), file_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
  struct stat status {};
  if (file_ < 0 || ::fstat(file_, &status) != 0) {
    throw InputError(fmt::format("{}: could not be read: {}", path, std::strerror(errno)));
  }
  size_ = static_cast<std::uint64_t>(status.st_size);
  try {
    read_header();
    while (read_chunk()) {
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
      sound_bytes_(other.sound_bytes_),
      n_unsolved_(other.n_unsolved_),
      header_(std::move(other.header_)),
      chunks_(std::move(other.chunks_)) {}

ShardReader::~ShardReader() {
  if (file_ >= 0) ::close(file_);
}

std::uint64_t ShardReader::next() const {
  return chunks_.empty() ? header_.first : chunks_.back().first + chunks_.back().n_rows;
}

std::string ShardReader::bytes(std::uint64_t at, std::uint64_t n) const {
  std::string all(n, '\0');
  std::uint64_t done = 0;
  while (done < n) {
    const ssize_t got = ::pread(file_, all.data() + done, n - done, static_cast<off_t>(at + done));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) throw InputError(fmt::format("{}: could not be read to its end", path_));
    done += static_cast<std::uint64_t>(got);
  }
  return all;
}

void ShardReader::read_header() {
  const InputError no_such_file(fmt::format("{}: this is no file of rows of a study, or was cut off at once", path_),
                                "delete it to begin anew");
  if (size_ < kFrame) throw no_such_file;
  const std::uint64_t n = number_at(bytes(0, 8), 0);
  if (n > kLargestHeader || n > size_ - kFrame) throw no_such_file;
  const std::string text = bytes(kFrame, n);
  if (sha256(text) != bytes(8, kDigits)) throw no_such_file;
  std::istringstream lines(text);
  std::string magic, word;
  ShardHeader& h = header_;
  std::getline(lines, magic);
  lines >> word >> h.plan >> word >> h.inputs >> word >> h.part >> h.parts >> word >> h.first >> h.end >> word >>
      h.n_values >> word;
  std::getline(lines >> std::ws, h.program);
  constexpr std::uint64_t kMostValues = 10'000;
  if (magic != kMagic || !lines || h.first > h.end || h.n_values == 0 || h.n_values > kMostValues) throw no_such_file;
  sound_bytes_ = kFrame + n;
}

bool ShardReader::read_chunk() {
  if (size_ - sound_bytes_ < kFrame) return false;
  const std::string frame = bytes(sound_bytes_, kFrame);
  const std::uint64_t n = number_at(frame, 0);
  if (n < kChunkHead || n > kLargestBlock || n > size_ - sound_bytes_ - kFrame) return false;
  const std::string content = bytes(sound_bytes_ + kFrame, n);
  if (sha256(content) != frame.substr(8)) return false;
  ChunkPlace place;
  place.first = number_at(content, 0);
  place.n_rows = number_at(content, 8);
  const std::uint64_t most_rows = (n - kChunkHead) / (8 * header_.n_values);
  if (place.first != next() || place.n_rows == 0 || place.n_rows > most_rows ||
      place.n_rows > header_.end - place.first) {
    return false;
  }
  const std::uint64_t n_bytes = 8 * header_.n_values * place.n_rows;
  place.values_at = sound_bytes_ + kFrame + kChunkHead;
  place.reasons_at = place.values_at + n_bytes;
  place.reasons_size = n - kChunkHead - n_bytes;
  for (std::size_t at = kChunkHead + n_bytes; at < n; ++at) n_unsolved_ += content[at] == '\n';
  chunks_.push_back(place);
  sound_bytes_ += kFrame + n;
  return true;
}

void ShardReader::append_values(std::size_t i, std::vector<double>& all) const {
  for (const ChunkPlace& chunk : chunks_) {
    const std::string raw = bytes(chunk.values_at + 8 * i * chunk.n_rows, 8 * chunk.n_rows);
    for (std::uint64_t k = 0; k < chunk.n_rows; ++k) {
      const std::uint64_t bits = number_at(raw, 8 * k);
      double value = 0;
      std::memcpy(&value, &bits, sizeof value);
      all.push_back(value);
    }
  }
}

void ShardReader::append_unsolved(std::vector<Unsolved>& all) const {
  for (const ChunkPlace& chunk : chunks_) {
    if (chunk.reasons_size == 0) continue;
    std::istringstream lines(bytes(chunk.reasons_at, chunk.reasons_size));
    Unsolved one{};
    while (lines >> one.scenario && std::getline(lines >> std::ws, one.reason)) all.push_back(one);
  }
}

ShardWriter::ShardWriter(const std::string& path, const ShardHeader& header)
    : path_(path), n_values_(header.n_values), next_(header.first) {
  constexpr mode_t kReadWriteAsUmaskAllows = 0666;
  file_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, kReadWriteAsUmaskAllows);
  if (file_ < 0) fail_to_write(path, errno);
  try {
    if (::flock(file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      throw InputError(fmt::format("{}: another process computes this part", path), "wait for it, or stop it first");
    }
    struct stat status {};
    if (::fstat(file_, &status) != 0) fail_to_write(path, errno);
    const std::string first = block(text_of(header));
    // A header that was cut off says nothing; the rest of one that is there decides.
    if (static_cast<std::uint64_t>(status.st_size) < first.size()) {
      if (::ftruncate(file_, 0) != 0) fail_to_write(path, errno);
      write(first);
      return;
    }
    const ShardReader there(path);
    const ShardHeader& h = there.header();
    std::string differs = difference(h, header);
    if (differs.empty() && (h.part != header.part || h.parts != header.parts)) differs = "another part";
    if (!differs.empty()) {
      throw InputError(fmt::format("{}: these rows are of {}", path, differs),
                       "results of both must not be mixed: name another output, or delete this file");
    }
    next_ = there.next();
    length_ = there.sound_bytes();
    if (::ftruncate(file_, static_cast<off_t>(length_)) != 0) fail_to_write(path, errno);
  } catch (...) {
    ::close(file_);
    throw;
  }
}

ShardWriter::~ShardWriter() { ::close(file_); }

void ShardWriter::append(const study::ScenarioChunk& chunk) {
  write(block(content_of(chunk, n_values_)));
  next_ = chunk.first + chunk.rows.size();
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
    // What was not written in full would be left out by readers anyhow.
    [[maybe_unused]] const int ignored = ::ftruncate(file_, static_cast<off_t>(length_));
    fail_to_write(path_, error);
  }
  length_ += bytes.size();
}

}  // namespace ringfilm::io
