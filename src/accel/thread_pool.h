// ThreadPool: the threads of one build, which divide its recursions among them.
#pragma once
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>

namespace accel {

class ThreadPool {
 public:
  /// A pool of one: everything is done by the caller.
  ThreadPool() = default;
  /// Runs body(pool) on a thread that can then call the functions below; returns when it has
  /// returned. What it throws is thrown again. With one thread, or fewer than kLeastShared `items`
  /// to build a tree of, body runs on this one alone.
  static void run(int threads, std::size_t items, const std::function<void(ThreadPool&)>& body);

  /// Fewer are sorted before threads are ready.
  static constexpr std::size_t kLeastShared = 16384;

  /// Calls both, side by side if a thread has nothing else to do, and returns when both have
  /// returned; they may call this function too. What one of them throws is thrown again.
  void both(const std::function<void()>& first, const std::function<void()>& second);

  /// Calls work(index) for every index below `count`, in ascending order of their starts, on any of
  /// the threads.
  void forEachIndex(std::size_t count, const std::function<void(std::size_t)>& work);

 private:
  struct Task;
  void callTimes(std::size_t times, const std::function<void()>& work);
  void serve();
  void runTask(Task& task, std::unique_lock<std::mutex>& lock);

  int threads_ = 1;
  std::mutex mutex_;
  std::condition_variable changed_;
  // Guarded by mutex_:
  std::deque<Task*> waiting_;  // tasks that nobody has begun, the oldest first
  bool hasEnded_ = false;
};

}  // namespace accel
