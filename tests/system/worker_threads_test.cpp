// Worker threads: how many are right, and that all work is done whatever happens.
#include "system/worker_threads.h"

#include <sched.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

#include "check.h"

TEST("no more threads are right than cores that the process may use") {
  cpu_set_t before;
  if (sched_getaffinity(0, sizeof before, &before) != 0) SKIP("affinity cannot be asked here");
  CHECK_EQUAL(hardwareThreads(), CPU_COUNT(&before));
  int core = 0;
  while (!CPU_ISSET(core, &before)) ++core;
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(core, &one);
  if (sched_setaffinity(0, sizeof one, &one) != 0) SKIP("affinity cannot be changed here");
  CHECK_EQUAL(hardwareThreads(), 1);
  sched_setaffinity(0, sizeof before, &before);
}

TEST("every index is worked on once, and the first exception comes out after the rest is done") {
  std::atomic<int> sum{0};
  runOnThreads(100, 1 << 16, [&](int index) { sum += index; });
  CHECK_EQUAL(sum.load(), 4950);  // 0 + 1 + ... + 99
  std::atomic<int> done{0};
  const auto failing = [&](int index) {
    if (index == 3) throw std::runtime_error("three");
    ++done;
  };
  CHECK_THROWS(runOnThreads(8, 1 << 16, failing), std::runtime_error);
  CHECK_EQUAL(done.load(), 7);
}

TEST("shared calls are each made once, on any number of threads; none begins after an exception") {
  for (const int threads : {1, 3, 100}) {
    for (const std::size_t count : {0u, 1u, 2u, 1000u}) {
      std::vector<std::atomic<int>> calls(count);
      shareOnThreads(threads, 1 << 16, count, [&](std::size_t i) { ++calls[i]; });
      for (const auto& each : calls) CHECK_EQUAL(each.load(), 1);
    }
  }
  std::atomic<int> begun{0};
  const auto failing = [&](std::size_t i) {
    ++begun;
    if (i == 0) throw std::runtime_error("the first");
    std::this_thread::sleep_for(std::chrono::microseconds(100));
  };
  CHECK_THROWS(shareOnThreads(2, 1 << 16, 3000, failing), std::runtime_error);
  CHECK(begun < 3000);  // the other thread would take 0.3 s for all of them
}

TEST("each thread that shares calls makes work of its own for them, once") {
  for (const int threads : {1, 3}) {
    std::atomic<int> made{0}, sum{0};
    const auto makeWork = [&] {
      ++made;
      return [&sum, own = 0](std::size_t) mutable { sum += ++own == 1; };
    };
    shareOnThreads(threads, 1 << 16, 1000, makeWork);
    CHECK(made >= 1 && made <= threads);
    CHECK(sum >= 1 && sum <= made);  // a thread may come too late for any call
  }
}
