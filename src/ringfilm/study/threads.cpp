#include "ringfilm/study/threads.hpp"

#include <algorithm>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace ringfilm::study {

int n_threads(int wanted) {
  return wanted > 0 ? wanted : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void on_threads(int n, const std::function<void(int)>& work) {
  std::mutex mutex;
  std::exception_ptr first;
  const auto guarded = [&](int i) {
    try {
      work(i);
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (first == nullptr) first = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> threads;
    int begun = 1;
    try {
      for (; begun < n; ++begun) threads.emplace_back(guarded, begun);
    } catch (const std::system_error&) {
      // No more threads than these.
    }
    if (n > 0) guarded(0);
    for (int i = begun; i < n; ++i) guarded(i);
  }
  if (first != nullptr) std::rethrow_exception(first);
}

}  // namespace ringfilm::study
