#include "ringfilm/io/inverse/point_store.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "ringfilm/base/error.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"

namespace ringfilm::io {
namespace {

using nlohmann::json;

/// The first line, by which the file is recognized.
constexpr const char* kHead = "{\"ringfilm\":\"points\",\"version\":1}\n";

/// A number of a line; null stands for what is not one.
double number_of_json(const json& value) {
  return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

json point_json(const std::string& key, const StoredPoint& point) {
  json line = {{"key", key}};
  if (!point.reason.empty()) {
    line["reason"] = point.reason;
    return line;
  }
  line["values"] = point.values;
  if (point.curves.empty()) return line;
  line["crank_angle"] = point.crank_angle_deg;
  line["curves"] = point.curves;
  return line;
}

StoredPoint point_of_json(const json& line) {
  StoredPoint point;
  point.reason = line.value("reason", "");
  if (line.contains("values")) {
    for (const auto& [name, value] : line.at("values").items()) point.values[name] = number_of_json(value);
  }
  if (!line.contains("curves")) return point;
  for (const json& angle : line.at("crank_angle")) point.crank_angle_deg.push_back(number_of_json(angle));
  for (const auto& [name, values] : line.at("curves").items()) {
    for (const json& value : values) point.curves[name].push_back(number_of_json(value));
  }
  return point;
}

}  // namespace

PointStore::PointStore(const std::string& path) : path_(path) {
  file_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file_ < 0) fail_to_write(path, errno);
  if (::flock(file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    ::close(file_);
    file_ = -1;
    throw InputError(path + ": another process is computing these points", "wait for it, or name another output");
  }
  try {
    std::string text;
    struct stat state {};
    if (::fstat(file_, &state) == 0) text.resize(static_cast<std::size_t>(state.st_size));
    std::size_t at = 0;
    while (at < text.size()) {
      const ssize_t n = ::pread(file_, text.data() + at, text.size() - at, static_cast<off_t>(at));
      if (n <= 0) throw InputError(path + ": cannot be read", "remove it, or name another output");
      at += static_cast<std::size_t>(n);
    }
    read(text);
  } catch (...) {
    ::close(file_);
    file_ = -1;
    throw;
  }
}

PointStore::~PointStore() {
  if (file_ >= 0) ::close(file_);
}

void PointStore::read(const std::string& text) {
  const std::string head = kHead;
  const bool is_begun = text.size() < head.size() && head.compare(0, text.size(), text) == 0;
  if (is_begun) {  // new, or cut off in its first line
    if (::ftruncate(file_, 0) != 0 || ::pwrite(file_, head.data(), head.size(), 0) != ssize_t(head.size())) {
      fail_to_write(path_, errno);
    }
    length_ = head.size();
    return;
  }
  if (text.compare(0, head.size(), head) != 0) {
    throw InputError(path_ + ": this is not a file of points of this program", "remove it, or name another output");
  }
  length_ = head.size();
  while (length_ < text.size()) {
    const std::size_t end = text.find('\n', length_);
    if (end == std::string::npos) break;
    const json line = json::parse(text.begin() + static_cast<std::ptrdiff_t>(length_),
                                  text.begin() + static_cast<std::ptrdiff_t>(end), nullptr, false);
    if (line.is_discarded() || !line.is_object() || !line.contains("key")) break;
    points_[line.at("key").get<std::string>()] = point_of_json(line);
    length_ = end + 1;
  }
  n_read_ = points_.size();
  if (length_ < text.size() && ::ftruncate(file_, static_cast<off_t>(length_)) != 0) fail_to_write(path_, errno);
}

std::optional<StoredPoint> PointStore::find(const std::string& key) const {
  const std::lock_guard lock(mutex_);
  const auto found = points_.find(key);
  return found == points_.end() ? std::nullopt : std::optional(found->second);
}

std::size_t PointStore::n_added() const {
  const std::lock_guard lock(mutex_);
  return n_added_;
}

void PointStore::add(const std::string& key, const StoredPoint& point) {
  const std::lock_guard lock(mutex_);
  if (!points_.emplace(key, point).second) return;
  ++n_added_;
  if (file_ < 0) return;
  const std::string line = point_json(key, point).dump(-1, ' ', false, json::error_handler_t::replace) + "\n";
  const ssize_t written = ::pwrite(file_, line.data(), line.size(), static_cast<off_t>(length_));
  if (written != static_cast<ssize_t>(line.size())) {
    const int reason = written < 0 ? errno : ENOSPC;
    [[maybe_unused]] const int cut = ::ftruncate(file_, static_cast<off_t>(length_));
    throw OutputError(fmt::format("{}: could not be written: {}; {} points are kept", path_, std::strerror(reason),
                                  points_.size() - 1));
  }
  length_ += line.size();
}

}  // namespace ringfilm::io
