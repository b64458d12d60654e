#include "ringfilm/instrument/formats/zip_archive.hpp"

#include <fmt/format.h>
#include <zip.h>

#include <algorithm>
#include <stdexcept>

#include "ringfilm/instrument/grid/binary_reader.hpp"

namespace ringfilm::instrument {
namespace {

constexpr char kCopyAgain[] = "the file was damaged on its way: copy it again from the instrument";

struct CloseEntry {
  void operator()(zip_file_t* entry) const { zip_fclose(entry); }
};

}  // namespace

struct ZipArchive::Handle {
  zip_t* archive = nullptr;
  ~Handle() { zip_discard(archive); }
};

ZipArchive::ZipArchive(const std::string& path) : path_(path), handle_(std::make_unique<Handle>()) {
  int code = 0;
  handle_->archive = zip_open(path.c_str(), ZIP_RDONLY, &code);
  if (handle_->archive == nullptr) {
    zip_error_t error;
    zip_error_init_with_code(&error, code);
    const std::string reason = zip_error_strerror(&error);
    zip_error_fini(&error);
    refuse(path, "the zip archive cannot be read: " + reason, kCopyAgain);
  }
}

ZipArchive::~ZipArchive() = default;

std::vector<std::string> ZipArchive::names() const {
  std::vector<std::string> result;
  const zip_int64_t count = zip_get_num_entries(handle_->archive, 0);
  for (zip_int64_t i = 0; i < count; ++i) {
    const char* const name = zip_get_name(handle_->archive, static_cast<zip_uint64_t>(i), 0);
    if (name != nullptr) result.emplace_back(name);
  }
  return result;
}

std::optional<std::uint64_t> ZipArchive::size(const std::string& name) const {
  zip_stat_t about;
  zip_stat_init(&about);
  if (zip_stat(handle_->archive, name.c_str(), 0, &about) != 0 || (about.valid & ZIP_STAT_SIZE) == 0) {
    return std::nullopt;
  }
  return about.size;
}

void ZipArchive::read_pieces(const std::string& name, std::uint64_t length,
                             const std::function<void(std::string_view)>& take) const {
  const std::unique_ptr<zip_file_t, CloseEntry> entry(zip_fopen(handle_->archive, name.c_str(), 0));
  if (!entry) {
    refuse(path_, fmt::format("{} cannot be opened in the archive: {}", name, zip_strerror(handle_->archive)),
           kCopyAgain);
  }
  std::string block(1 << 18, '\0');
  std::uint64_t taken = 0;
  while (true) {
    // One byte more than required reveals an entry that is longer than it may be.
    const std::uint64_t requested = std::min<std::uint64_t>(block.size(), length - taken + 1);
    const zip_int64_t got = zip_fread(entry.get(), block.data(), requested);
    if (got < 0) {
      refuse(path_, fmt::format("{} cannot be unpacked: {}", name, zip_file_strerror(entry.get())), kCopyAgain);
    }
    if (got == 0) break;
    taken += static_cast<std::uint64_t>(got);
    if (taken > length) {
      refuse(path_, fmt::format("{} unpacks to more than {} bytes", name, length),
             "the sizes in the file contradict each other: copy it again from the instrument");
    }
    take(std::string_view(block).substr(0, static_cast<std::size_t>(got)));
  }
  if (taken != length) {
    refuse(path_, fmt::format("{} holds {} bytes, and {} are required", name, taken, length), kCopyAgain);
  }
}

std::string ZipArchive::read(const std::string& name, std::uint64_t limit) const {
  const std::optional<std::uint64_t> stated = size(name);
  if (!stated) refuse(path_, "the archive has no entry " + name, "is it the right file?");
  if (*stated > limit) {
    refuse(path_, fmt::format("{} unpacks to {} bytes, over the limit of {}", name, *stated, limit),
           "is it the right file?");
  }
  std::string bytes;
  bytes.reserve(static_cast<std::size_t>(std::min<std::uint64_t>(*stated, 1 << 20)));
  read_pieces(name, *stated, [&bytes](std::string_view piece) { bytes += piece; });
  return bytes;
}

namespace {

/// Throws for what can fail only for lack of memory.
void require(bool good) {
  if (!good) throw std::runtime_error("libzip cannot write an archive into memory");
}

}  // namespace

std::string zip_bytes(const std::vector<std::pair<std::string, std::string>>& entries) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* const target = zip_source_buffer_create(nullptr, 0, 0, &error);
  require(target != nullptr);
  zip_source_keep(target);
  zip_t* const archive = zip_open_from_source(target, ZIP_TRUNCATE, &error);
  require(archive != nullptr);
  constexpr zip_uint16_t kFirstDay = (1 << 5) | 1;  // 1 January 1980
  for (const auto& [name, bytes] : entries) {
    zip_source_t* const source = zip_source_buffer(archive, bytes.data(), bytes.size(), 0);
    const zip_int64_t index = zip_file_add(archive, name.c_str(), source, ZIP_FL_ENC_UTF_8);
    require(index >= 0);
    const auto entry = static_cast<zip_uint64_t>(index);
    require(zip_set_file_compression(archive, entry, ZIP_CM_STORE, 0) == 0);
    require(zip_file_set_dostime(archive, entry, 0, kFirstDay, 0) == 0);
  }
  require(zip_close(archive) == 0);
  require(zip_source_open(target) == 0);
  zip_source_seek(target, 0, SEEK_END);
  std::string result(static_cast<std::size_t>(zip_source_tell(target)), '\0');
  zip_source_seek(target, 0, SEEK_SET);
  require(zip_source_read(target, result.data(), result.size()) == static_cast<zip_int64_t>(result.size()));
  zip_source_close(target);
  zip_source_free(target);
  return result;
}

}  // namespace ringfilm::instrument
