// ThreadPool: every call is made once, however calls nest, and failures reach the caller.
#include "accel/thread_pool.h"

#include <atomic>
#include <stdexcept>
#include <string>
#include <vector>

#include "check.h"

namespace {

using accel::ThreadPool;

/// Adds 1 to counts[begin .. end), by halves.
void countUp(std::vector<int>& counts, std::size_t begin, std::size_t end, ThreadPool& pool) {
  if (end - begin == 1) {
    ++counts[begin];
    return;
  }
  const std::size_t middle = begin + (end - begin) / 3 + (end - begin) % 3 / 2;
  pool.both([&] { countUp(counts, begin, middle, pool); },
            [&] { countUp(counts, middle, end, pool); });
}

}  // namespace

TEST("forks in forks, and indices in indices, are all done when the call returns, each once") {
  for (const int threads : {1, 2, 3, 16}) {
    std::vector<int> counts(2000);
    std::atomic<int> calls{0};
    ThreadPool::run(threads, ThreadPool::kLeastShared, [&](ThreadPool& pool) {
      countUp(counts, 0, counts.size(), pool);
      pool.forEachIndex(40, [&](std::size_t i) {
        pool.forEachIndex(50, [&](std::size_t k) {
          ++counts[50 * i + k];
          ++calls;
        });
        pool.forEachIndex(0, [&](std::size_t) { ++calls; });
      });
      CHECK_EQUAL(calls, 2000);
    });
    int wrong = 0;
    for (const int count : counts) wrong += count != 2;
    CHECK_EQUAL(wrong, 0);
  }
}

TEST("what one half or one index throws is thrown again when the others have ended") {
  for (const int threads : {1, 2, 16}) {
    for (const bool isFirst : {true, false}) {
      std::atomic<int> running{0};
      const auto work = [&](bool fails) {
        ++running;
        if (fails) throw std::runtime_error("half");
        --running;
      };
      std::string found;
      try {
        ThreadPool::run(threads, ThreadPool::kLeastShared, [&](ThreadPool& pool) {
          pool.forEachIndex(8, [&](std::size_t i) {
            pool.both([&] { work(isFirst && i == 5); }, [&] { work(!isFirst && i == 5); });
          });
        });
      } catch (const std::runtime_error& failure) {
        found = failure.what();
      }
      CHECK_EQUAL(found, "half");
      CHECK_EQUAL(running, 1);  // the one that failed
    }
  }
}
