#include "ringfilm/study/ensemble/threads.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>

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

TEST(Threads, WorkIsLookedAfterFromTheThreadOfTheCaller) {
  const std::thread::id here = std::this_thread::get_id();
  std::atomic<int> looked = 0;
  run_while_polling(
      [&] {
        EXPECT_NE(std::this_thread::get_id(), here);
        while (looked < 2) std::this_thread::yield();
      },
      [&] {
        EXPECT_EQ(std::this_thread::get_id(), here);
        ++looked;
      });
  EXPECT_GE(looked, 2);
}

TEST(Threads, WhatLookingAfterWorkFindsOutIsRethrownWhenTheWorkHasEnded) {
  std::atomic<bool> is_to_end = false, has_ended = false;
  const auto work = [&] {
    while (!is_to_end) std::this_thread::yield();
    has_ended = true;
    throw std::logic_error("of the work, which was reported to end");
  };
  const auto look = [&] {
    is_to_end = true;
    throw std::runtime_error("of the look");
  };
  EXPECT_THROW(run_while_polling(work, look), std::runtime_error);
  EXPECT_TRUE(has_ended);
}

TEST(Threads, WhatWorkThrowsThatIsLookedAfterIsRethrown) {
  EXPECT_THROW(run_while_polling([] { throw std::runtime_error("from the work"); }, [] {}), std::runtime_error);
}

TEST(Threads, AsManyAsRequestedAndAtLeastOne) {
  EXPECT_EQ(n_threads(5), 5);
  EXPECT_GE(n_threads(0), 1);
}

}  // namespace
}  // namespace ringfilm::study
