#include <algorithm>
#include <vector>

#include "fuzz_target.hpp"
#include "input_file.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/io/storage/digest.hpp"
#include "ringfilm/io/storage/shard_file.hpp"

namespace {

/// Nobody hits upon the digest of a block by chance. So what comes is taken for the contents of blocks, each behind its
/// size in two bytes, and gets the frame that it would have in a file; what begins with 'r' is left raw.
std::string framed(const std::uint8_t* data, std::size_t size) {
  if (size > 0 && data[0] == 'r') return {data + 1, data + size};
  std::string file;
  for (std::size_t at = 0; at + 2 <= size;) {
    const std::size_t n = std::min<std::size_t>(data[at] + 256 * data[at + 1], size - at - 2);
    const std::string content(data + at + 2, data + at + 2 + n);
    for (int i = 0; i < 8; ++i) file.push_back(static_cast<char>(n >> (8 * i) & 0xff));
    file += ringfilm::io::sha256(content) + content;
    at += 2 + n;
  }
  return file;
}

}  // namespace

/// Rows of a study, of which all that passes is read.
RINGFILM_FUZZ_TARGET(study_rows) {
  using namespace ringfilm;
  const std::string bytes = framed(data, size);
  const std::string path =
      fuzz::input_file(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size(), "a.rows");
  try {
    const io::ShardReader rows(path);
    if (rows.next() < rows.header().first || rows.next() > rows.header().end) __builtin_trap();
    std::vector<double> values;
    for (std::uint64_t i = 0; i < std::min<std::uint64_t>(rows.header().n_values, 3); ++i) {
      values.clear();
      rows.append_values(i, values);
      if (values.size() != rows.next() - rows.header().first) __builtin_trap();
    }
    std::vector<io::ShardReader::Unsolved> unsolved;
    rows.append_unsolved(unsolved);
    for (const auto& one : unsolved) {
      if (one.scenario < rows.header().first || one.scenario >= rows.next()) __builtin_trap();
    }
    std::vector<io::SharedNote> notes;
    rows.append_notes({rows.header().first, rows.next()}, notes);
    for (const auto& one : notes) {
      if (one.scenarios.empty() || one.scenarios.back() >= rows.next()) __builtin_trap();
    }
  } catch (const InputError& error) {
    describe(error.faults());
  }
  return 0;
}
