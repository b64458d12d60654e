#include "ringfilm/study/threads.hpp"

#include <gtest/gtest.h>

#include <mutex>
#include <set>
#include <stdexcept>

namespace ringfilm::study {
namespace {

TEST(Threads, EachPieceOfWorkIsDoneOnce) {
  std::mutex mutex;
  std::multiset<int> done;
  on_threads(7, [&](int i) {
    const std::lock_guard lock(mutex);
    done.insert(i);
  });
  EXPECT_EQ(done, (std::multiset<int>{0, 1, 2, 3, 4, 5, 6}));
}

TEST(Threads, NoWorkIsDoneForNone) {
  on_threads(0, [](int) { ADD_FAILURE(); });
}

TEST(Threads, AnExceptionIsRethrownWhenAllHaveEnded) {
  std::mutex mutex;
  int ended = 0;
  const auto work = [&](int i) {
    if (i == 1) throw std::runtime_error("from a thread");
    const std::lock_guard lock(mutex);
    ++ended;
  };
  EXPECT_THROW(on_threads(3, work), std::runtime_error);
  EXPECT_EQ(ended, 2);
}

TEST(Threads, AsManyAsWantedAndAtLeastOne) {
  EXPECT_EQ(n_threads(5), 5);
  EXPECT_GE(n_threads(0), 1);
}

}  // namespace
}  // namespace ringfilm::study
