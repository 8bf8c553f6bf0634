// Work shared out by index, for the builder.
#pragma once
#include <algorithm>
#include <atomic>
#include <cstddef>

#include "system/worker_threads.h"

namespace accel {

/// Calls work(worker, index) for every index below `count`, in ascending order of their starts, on
/// up to `threads` threads; 0 <= worker < threads. With one thread or one index, on this one.
template <class Work>
void forEachIndex(int threads, std::size_t count, const Work& work) {
  constexpr std::size_t kStackBytes = 1 << 20;
  const int workers = int(std::min(std::size_t(threads), count));
  if (workers <= 1) {
    for (std::size_t index = 0; index < count; ++index) work(0, index);
    return;
  }
  std::atomic<std::size_t> next{0};
  runOnThreads(workers, kStackBytes, [&](int worker) {
    for (std::size_t index; (index = next++) < count;) work(worker, index);
  });
}

/// How many threads pay for `count` short pieces of work: starting one takes as long as a few, and
/// much longer on a busy machine.
inline int threadsForShort(int threads, std::size_t count) { return count < 4 ? 1 : threads; }

}  // namespace accel
