// ThreadPool: the other threads sleep between the steps; whoever wakes late finds the step gone and
// sleeps on.
//
// A step is a range of indices. The caller publishes it, wakes all, and takes indices itself from
// one atomic counter like everybody else; when there are none left it waits only for those threads
// that have begun one. The first exception of a step ends it and is thrown again by the caller.
#include "accel/thread_pool.h"

namespace accel {

/// Sends the other threads home when the body has returned or thrown.
struct ThreadPool::Ending {
  ThreadPool& pool;
  ~Ending() {
    const std::lock_guard<std::mutex> lock(pool.mutex_);
    pool.ended_ = true;
    pool.changed_.notify_all();
  }
};

void ThreadPool::run(int threads, std::size_t items, const std::function<void(ThreadPool&)>& body) {
  constexpr std::size_t kStackBytes = 1 << 20;
  ThreadPool pool(items < kLeastShared ? 1 : threads);
  if (pool.threads_ == 1) return body(pool);
  runOnThreads(threads, kStackBytes, [&](int worker) {
    if (worker != 0) return pool.serve();
    const Ending ending{pool};
    body(pool);
  });
}

void ThreadPool::forEachIndex(std::size_t count, const std::function<void(std::size_t)>& work) {
  if (threads_ == 1 || count <= 1) {
    for (std::size_t index = 0; index < count; ++index) work(index);
    return;
  }
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    work_ = &work;
    count_ = count;
    next_ = 0;
    ++step_;
  }
  changed_.notify_all();
  takeIndices(work, count);
  std::unique_lock<std::mutex> lock(mutex_);
  work_ = nullptr;
  changed_.wait(lock, [&] { return busy_ == 0; });
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

void ThreadPool::serve() {
  std::unique_lock<std::mutex> lock(mutex_);
  for (std::size_t done = 0;;) {
    changed_.wait(lock, [&] { return ended_ || (work_ && step_ != done); });
    if (ended_) return;
    done = step_;
    ++busy_;
    const auto& work = *work_;
    const std::size_t count = count_;
    lock.unlock();
    takeIndices(work, count);
    lock.lock();
    if (--busy_ == 0) changed_.notify_all();
  }
}

void ThreadPool::takeIndices(const std::function<void(std::size_t)>& work, std::size_t count) {
  try {
    for (std::size_t index; (index = next_++) < count;) work(index);
  } catch (...) {
    next_ = count;  // no more of this step
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!failure_) failure_ = std::current_exception();
  }
}

}  // namespace accel
