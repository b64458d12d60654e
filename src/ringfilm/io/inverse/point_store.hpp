#pragma once
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

/// The cases that fits and optimisations have computed, in a file that a kill leaves usable.
namespace ringfilm::io {

/// What came of a case.
struct StoredPoint {
  std::string reason;                                 ///< why it has no solution; empty: it has one
  std::map<std::string, double> values;               ///< [SI]
  std::vector<double> crank_angle_deg;                ///< axis of the curves [degree]
  std::map<std::string, std::vector<double>> curves;  ///< [SI]
};

/// Points by a key that determines their numbers. A file has one line of JSON for each point, `{"key": "...",
/// "values": {...}}`; a line that a kill cut off is removed when the file is opened. May be used by several threads.
class PointStore {
 public:
  PointStore() = default;  ///< without a file: points are kept in memory alone
  /// Opens the file, or begins it. Throws InputError for a file of another kind or in use by another process,
  /// OutputError.
  explicit PointStore(const std::string& path);
  PointStore(const PointStore&) = delete;
  PointStore& operator=(const PointStore&) = delete;
  ~PointStore();

  std::optional<StoredPoint> find(const std::string& key) const;
  /// Throws OutputError; points before are kept.
  void add(const std::string& key, const StoredPoint& point);

  std::size_t n_read() const { return n_read_; }  ///< points that the file had when it was opened
  std::size_t n_added() const;                    ///< points since then

 private:
  void read(const std::string& text);

  std::string path_;
  int file_ = -1;
  std::uint64_t length_ = 0;
  std::size_t n_read_ = 0, n_added_ = 0;
  std::map<std::string, StoredPoint> points_;
  mutable std::mutex mutex_;
};

}  // namespace ringfilm::io
