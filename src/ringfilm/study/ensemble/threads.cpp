#include "ringfilm/study/ensemble/threads.hpp"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace ringfilm::study {

int n_threads(int requested) {
  return requested > 0 ? requested : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
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

void run_while_polling(const std::function<void()>& work, const std::function<void()>& look) {
  std::mutex mutex;
  std::condition_variable ended;
  bool has_ended = false;
  std::exception_ptr of_work, of_look;
  {
    const std::jthread worker([&] {
      try {
        work();
      } catch (...) {
        of_work = std::current_exception();
      }
      const std::lock_guard lock(mutex);
      has_ended = true;
      ended.notify_all();
    });
    std::unique_lock lock(mutex);
    while (!ended.wait_for(lock, std::chrono::milliseconds(50), [&] { return has_ended; })) {
      lock.unlock();
      try {
        if (of_look == nullptr) look();
      } catch (...) {
        of_look = std::current_exception();
      }
      lock.lock();
    }
  }
  if (of_look != nullptr) std::rethrow_exception(of_look);
  if (of_work != nullptr) std::rethrow_exception(of_work);
}

}  // namespace ringfilm::study
