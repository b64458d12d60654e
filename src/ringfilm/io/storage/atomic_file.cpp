#include "ringfilm/io/storage/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <functional>
#include <system_error>
#include <utility>

#include "ringfilm/base/display.hpp"
#include "ringfilm/base/error.hpp"

namespace ringfilm::io {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPartial = ".partial-";

/// An open file that is closed at the end of its scope.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }

  int number() const { return number_; }
  /// Closes; returns whether all that was written has arrived.
  bool close() { return ::close(std::exchange(number_, -1)) == 0; }

 private:
  int number_;
};

fs::path folder_of(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : fs::path("."); }

/// Where the bytes go when `path` is a symbolic link, else `path`.
fs::path target_of(const fs::path& path) {
  std::error_code error;
  if (!fs::is_symlink(path, error)) return path;
  const fs::path target = fs::weakly_canonical(path, error);
  return error ? path : target;
}

/// A device or a pipe cannot be replaced by a file: /dev/null must stay what it is.
bool is_device(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

/// The device to which nothing can be written, whoever asks: full(4).
bool is_dev_full(const fs::path& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 && S_ISCHR(status.st_mode) && status.st_rdev == makedev(1, 7);
}

bool write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(file, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

/// The process that would have written this partial file of `target`; 0 if it is not such a file.
long writer_of(const std::string& name, const std::string& target) {
  const std::string start = target + std::string(kPartial);
  if (name.compare(0, start.size(), start) != 0) return 0;
  constexpr std::size_t kMaxDigits = 9;
  const std::string number =
      name.substr(start.size(), name.find_first_not_of("0123456789", start.size()) - start.size());
  return number.empty() || number.size() > kMaxDigits ? 0 : std::stol(number);
}

/// True if nobody writes it: its process is gone here, and nobody elsewhere (a shared folder) holds its lock.
bool is_left_over(const fs::path& partial, long process) {
  if (process == ::getpid() || ::kill(static_cast<pid_t>(process), 0) == 0 || errno != ESRCH) return false;
  const Descriptor file(::open(partial.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW));
  return file.number() >= 0 && ::flock(file.number(), LOCK_EX | LOCK_NB) == 0;
}

/// Calls back with each partial file of a target and the process that would have written it.
void each_partial(const fs::path& target, const std::function<void(const fs::path&, long)>& found) {
  std::error_code error;
  for (fs::directory_iterator entry(folder_of(target), error), end; !error && entry != end; entry.increment(error)) {
    const long process = writer_of(entry->path().filename().string(), target.filename().string());
    if (process > 0) found(entry->path(), process);
  }
}

void remove_left_over_partials(const fs::path& target) {
  each_partial(target, [](const fs::path& partial, long process) {
    if (is_left_over(partial, process)) ::unlink(partial.c_str());
  });
}

bool is_locked(const fs::path& file) {
  const Descriptor open(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW));
  return open.number() >= 0 && ::flock(open.number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
}

/// A file that is certainly ours alone, open for writing; -1 if there is one of that name already.
int create(const std::string& path) {
  constexpr mode_t kReadWriteAsUmaskAllows = 0666;
  return ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kReadWriteAsUmaskAllows);
}

/// Creates a partial file of a target, open for writing; throws OutputError.
int create_partial(const std::string& target, std::string& path) {
  const std::string name = target + std::string(kPartial) + std::to_string(::getpid());
  path = name;
  int file = create(path);
  // The name is taken by another thread, or by the same process number in another container.
  for (int n = 1; file < 0 && errno == EEXIST && n < 1000; ++n) {
    path = name + "-" + std::to_string(n);
    file = create(path);
  }
  if (file < 0) fail_to_write(target, errno);
  return file;
}

/// @param shown how errors name the file
void write_directly(const std::string& path, std::string_view bytes, int flags, const std::string& shown) {
  Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC | flags));
  if (file.number() < 0) fail_to_write(shown, errno);
  ::flock(file.number(), LOCK_EX | LOCK_NB);  // best effort: not every file system has locks
  if (!write_all(file.number(), bytes) || !file.close()) fail_to_write(shown, errno);
}

/// Who may read and write the file that is replaced may do so with the one in its place.
void take_over_mode(const std::string& from, int file) {
  struct stat status {};
  constexpr mode_t kPermissions = 0777;
  if (::stat(from.c_str(), &status) == 0) ::fchmod(file, status.st_mode & kPermissions);
}

/// The file aside has the name of `target` and something behind it; where that is too long, nothing can be written.
void check_length(const std::string& path, const fs::path& target) {
  constexpr std::size_t kMaxEnd = kPartial.size() + 7 + 4;  // a process up to 2^22 and "-999", see AsideFile
  const long name = ::pathconf(folder_of(target).c_str(), _PC_NAME_MAX);
  const std::size_t most_of_name = name > 0 ? static_cast<std::size_t>(name) : NAME_MAX;
  if (target.filename().native().size() + kMaxEnd > most_of_name || target.native().size() + kMaxEnd >= PATH_MAX) {
    throw InputError(path + ": the name of the file is too long",
                     "a name in this folder may have " + std::to_string(most_of_name - kMaxEnd) +
                         " bytes, with its folders " + std::to_string(PATH_MAX - 1 - kMaxEnd));
  }
}

}  // namespace

void fail_to_write(const std::string& path, const std::string& reason) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  const std::string fate = fs::is_regular_file(status) ? " (the file of that name keeps what it held before)"
                           : fs::exists(status)        ? ""
                                                       : " (there is no file of that name)";
  throw OutputError(path + ": could not be written: " + reason + fate);
}

void fail_to_write(const std::string& path, int error_number) {
  fail_to_write(path, std::string(std::strerror(error_number)));
}

void check_can_write(const std::string& path, Sink sink) {
  if (path.empty()) throw InputError("the name of an output file is empty");
  const fs::path target = target_of(path);
  const fs::path folder = folder_of(target);
  std::error_code error;
  if (fs::is_directory(target, error)) {
    throw InputError(path + ": this is a folder", "a file name is required here");
  }
  if (error == std::errc::filename_too_long) check_length(path, target);
  if (!fs::exists(folder, error)) {
    throw InputError(path + ": the folder " + folder.string() + " does not exist",
                     "make it first, or name another one");
  }
  if (!fs::is_directory(folder, error)) {
    throw InputError(path + ": " + folder.string() + " is not a folder", "name a file in a folder that exists");
  }
  if (is_device(target)) {
    if (sink == Sink::kFile) throw InputError(path + ": this is a device or a pipe", "a file name is required here");
    if (is_dev_full(target)) throw InputError(path + ": nothing can be written to this device", "name a file");
    if (::access(target.c_str(), W_OK) != 0) {
      throw InputError(path + ": the device or pipe is not writable: " + std::strerror(errno), "name a file");
    }
    return;
  }
  if (::access(folder.c_str(), W_OK | X_OK) != 0) {
    throw InputError(path + ": the folder " + folder.string() + " is not writable: " + std::strerror(errno),
                     "name a file in a folder in which you may write");
  }
  check_length(path, target);
}

OutputClaim::OutputClaim(const std::string& path) {
  const fs::path target = target_of(path);
  if (is_device(target)) return;
  // Two that begin at the same moment do so one after the other; not every file system has locks.
  const Descriptor folder(::open(folder_of(target).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  while (folder.number() >= 0 && ::flock(folder.number(), LOCK_EX) != 0 && errno == EINTR) {
  }
  remove_left_over_partials(target);
  each_partial(target, [&path](const fs::path& partial, long) {
    if (!is_locked(partial)) return;
    throw InputError(path + ": another process computes this file now",
                     "wait for it, stop it first, or name another output");
  });
  file_ = create_partial(target.string(), partial_);
  ::flock(file_, LOCK_EX | LOCK_NB);
}

OutputClaim::OutputClaim(OutputClaim&& other) noexcept
    : partial_(std::exchange(other.partial_, {})), file_(std::exchange(other.file_, -1)) {}

OutputClaim::~OutputClaim() {
  if (file_ < 0) return;
  ::unlink(partial_.c_str());
  ::close(file_);
}

AsideFile::AsideFile(const std::string& target) : target_(target_of(target).string()) {
  if (is_device(target_)) fail_to_write(target, "this is a device or a pipe");
  remove_left_over_partials(target_);
  ::close(create_partial(target_, path_));
}

AsideFile::~AsideFile() {
  if (!path_.empty()) ::unlink(path_.c_str());
}

void AsideFile::fill(std::string_view bytes) {
  write_directly(path_, bytes, O_TRUNC, target_);
  const Descriptor file(::open(path_.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.number() < 0 || ::fsync(file.number()) != 0) fail_to_write(target_, errno);
}

void AsideFile::append(std::string_view bytes) { write_directly(path_, bytes, O_APPEND, target_); }

void AsideFile::reserve(std::uint64_t bytes) {
  const auto refuse = [&](int error_number) {
    const double megabytes = number_in(static_cast<double>(bytes), kMegabyte);
    fail_to_write(target_, fmt::format("up to {:.0f} MB are required: {}", megabytes, std::strerror(error_number)));
  };
  struct rlimit most {};
  if (::getrlimit(RLIMIT_FSIZE, &most) == 0 && most.rlim_cur != RLIM_INFINITY && bytes > most.rlim_cur) refuse(EFBIG);
  const Descriptor file(::open(path_.c_str(), O_RDWR | O_CLOEXEC));
  if (file.number() < 0) fail_to_write(target_, errno);
#ifdef FALLOC_FL_KEEP_SIZE
  is_reserved_ = true;
  int status = 0;
  do {
    status = ::fallocate(file.number(), FALLOC_FL_KEEP_SIZE, 0, static_cast<off_t>(bytes));
  } while (status != 0 && errno == EINTR);
  if (status == 0) return;
  if (errno != EOPNOTSUPP && errno != ENOSYS) refuse(errno);
#endif
  struct statvfs disk {};
  if (::fstatvfs(file.number(), &disk) == 0 && disk.f_bavail * disk.f_frsize < bytes) refuse(ENOSPC);
}

void AsideFile::put_in_place() {
  {
    const Descriptor file(::open(path_.c_str(), (is_reserved_ ? O_RDWR : O_RDONLY) | O_CLOEXEC));
    struct stat status {};
    // Blocks beyond its end belong to a file until its length is set.
    if (is_reserved_ && ::fstat(file.number(), &status) == 0 && ::ftruncate(file.number(), status.st_size) != 0) {
      fail_to_write(target_, errno);
    }
    if (file.number() < 0 || ::fsync(file.number()) != 0) fail_to_write(target_, errno);
    take_over_mode(target_, file.number());  // not before: what is read-only could not be filled
  }
  if (::rename(path_.c_str(), target_.c_str()) != 0) fail_to_write(target_, errno);
  path_.clear();
  // The new name itself; some file systems cannot do that, which is harmless.
  const Descriptor folder(::open(folder_of(target_).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.number() >= 0) ::fsync(folder.number());
}

void write_atomically(const std::string& path, std::string_view bytes) {
  if (is_device(path)) return write_directly(path, bytes, 0, path);
  AsideFile file(path);
  write_directly(file.path(), bytes, O_TRUNC, path);
  file.put_in_place();
}

}  // namespace ringfilm::io
