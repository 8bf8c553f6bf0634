// ThreadPool: the threads of one build. They are started once: a build has dozens of short parallel
// steps, each shorter than starting a thread would take.
#pragma once
#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <utility>

#include "system/worker_threads.h"

namespace accel {

class ThreadPool {
 public:
  /// A pool of one: everything is done by the caller.
  ThreadPool() : threads_(1) {}
  /// Runs body(pool) on a thread that can then call forEachIndex; returns when it has returned.
  /// What it throws is thrown again. With one thread, or fewer than kLeastShared `items` to build a
  /// tree of, body runs on this one alone.
  static void run(int threads, std::size_t items, const std::function<void(ThreadPool&)>& body);

  static constexpr std::size_t kLeastShared = 16384;

  int threads() const { return threads_; }

  /// Calls work(index) for every index below `count`, in ascending order of their starts, on any of
  /// the threads. A thread that the system is slow to run is not waited for.
  void forEachIndex(std::size_t count, const std::function<void(std::size_t)>& work);

 private:
  struct Ending;
  explicit ThreadPool(int threads) : threads_(threads) {}
  void serve();
  void takeIndices(const std::function<void(std::size_t)>& work, std::size_t count);

  const int threads_;
  std::mutex mutex_;
  std::condition_variable changed_;
  // Guarded by mutex_, but for next_:
  const std::function<void(std::size_t)>* work_ = nullptr;  // null: nothing to do
  std::size_t count_ = 0, step_ = 0;
  std::atomic<std::size_t> next_{0};
  int busy_ = 0;
  bool ended_ = false;
  std::exception_ptr failure_;
};

}  // namespace accel
