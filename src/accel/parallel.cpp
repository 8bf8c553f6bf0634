// Team: helpers sleep between the steps; whoever is late finds the step gone and sleeps on.
#include "accel/parallel.h"

namespace accel {

void Team::run(int threads, std::size_t items, const std::function<void(Team&)>& body) {
  constexpr std::size_t kStackBytes = 1 << 20;
  Team team(items < kLeastShared ? 1 : threads);
  if (team.threads_ == 1) return body(team);
  runOnThreads(threads, kStackBytes, [&](int worker) {
    if (worker != 0) return team.serve();
    std::exception_ptr failure;
    try {
      body(team);
    } catch (...) {
      failure = std::current_exception();
    }
    {
      const std::lock_guard<std::mutex> lock(team.mutex_);
      team.ended_ = true;
    }
    team.changed_.notify_all();
    if (failure) std::rethrow_exception(failure);
  });
}

void Team::forEachIndex(std::size_t count, const std::function<void(std::size_t)>& work) {
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

void Team::serve() {
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

void Team::takeIndices(const std::function<void(std::size_t)>& work, std::size_t count) {
  try {
    for (std::size_t index; (index = next_++) < count;) work(index);
  } catch (...) {
    next_ = count;  // no more of this step
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!failure_) failure_ = std::current_exception();
  }
}

}  // namespace accel
