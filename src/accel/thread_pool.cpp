// ThreadPool: who forks leaves the second half where others find it.
//
// A thread with nothing to do takes the task that waits longest, mostly the largest: so a build
// soon falls into large parts of which each thread does one alone. Who is done with its first half
// does the second one itself if nobody has begun it; else it does others' tasks until that is done.
// No thread that the system is slow to run is waited for, unless it has begun something.
#include "accel/thread_pool.h"

#include <algorithm>
#include <atomic>
#include <exception>

#include "system/worker_threads.h"

namespace accel {

struct ThreadPool::Task {
  const std::function<void()>& work;
  bool isDone = false;
  std::exception_ptr failure = nullptr;

  void run() {
    try {
      work();
    } catch (...) {
      failure = std::current_exception();
    }
  }
};

void ThreadPool::run(int threads, std::size_t items, const std::function<void(ThreadPool&)>& body) {
  constexpr std::size_t kStackBytes = 1 << 20;
  ThreadPool pool;
  if (threads == 1 || items < kLeastShared) return body(pool);
  pool.threads_ = threads;
  const std::function<void()> work = [&] { body(pool); };
  Task whole{work};
  runOnThreads(threads, kStackBytes, [&](int worker) {
    if (worker != 0) return pool.serve();
    whole.run();
    const std::lock_guard<std::mutex> lock(pool.mutex_);
    pool.hasEnded_ = true;
    pool.changed_.notify_all();
  });
  if (whole.failure) std::rethrow_exception(whole.failure);
}

void ThreadPool::both(const std::function<void()>& first, const std::function<void()>& second) {
  if (threads_ == 1) {
    first();
    return second();
  }
  Task mine{first}, other{second};
  std::unique_lock<std::mutex> lock(mutex_);
  waiting_.push_back(&other);
  lock.unlock();
  changed_.notify_one();
  mine.run();
  lock.lock();
  while (!other.isDone) {
    const bool isWaiting = std::count(waiting_.begin(), waiting_.end(), &other) != 0;
    if (waiting_.empty()) {
      changed_.wait(lock);
    } else {
      runTask(isWaiting ? other : *waiting_.front(), lock);
    }
  }
  for (const std::exception_ptr& failure : {mine.failure, other.failure}) {
    if (failure) std::rethrow_exception(failure);
  }
}

/// Calls `work` so many times, side by side as far as threads are free.
void ThreadPool::callTimes(std::size_t times, const std::function<void()>& work) {
  if (times == 1) return work();
  both([&] { callTimes(times / 2, work); }, [&] { callTimes(times - times / 2, work); });
}

void ThreadPool::forEachIndex(std::size_t count, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next{0};
  callTimes(std::clamp<std::size_t>(count, 1, std::size_t(threads_)), [&] {
    for (std::size_t index; (index = next++) < count;) work(index);
  });
}

void ThreadPool::serve() {
  std::unique_lock<std::mutex> lock(mutex_);
  for (;;) {
    changed_.wait(lock, [&] { return hasEnded_ || !waiting_.empty(); });
    if (hasEnded_) return;
    runTask(*waiting_.front(), lock);
  }
}

/// Does a waiting task; the lock is held before and afterwards.
void ThreadPool::runTask(Task& task, std::unique_lock<std::mutex>& lock) {
  waiting_.erase(std::find(waiting_.begin(), waiting_.end(), &task));
  lock.unlock();
  task.run();
  lock.lock();
  task.isDone = true;
  changed_.notify_all();
}

}  // namespace accel
