// SavingThread.
#include "cli/saving_thread.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "image/temporary_names.h"

SavingThread::SavingThread(Save save) : save_(std::move(save)) {
  if (pipe2(ends_, O_CLOEXEC | O_NONBLOCK) != 0) {
    throw std::system_error(errno, std::generic_category(), "cannot make a pipe");
  }
  try {
    thread_ = std::thread([this] { run(); });
  } catch (...) {
    close(ends_[0]);
    close(ends_[1]);
    throw;
  }
  passSignalsTo(ends_[1]);
}

SavingThread::~SavingThread() {
  passSignalsTo(-1);
  const unsigned char stop = 0;
  // The pipe is not full: whoever sent so many signals would have been answered by the first one.
  while (write(ends_[1], &stop, 1) < 0 && errno == EINTR) {
  }
  thread_.join();
  close(ends_[0]);
  close(ends_[1]);
}

void SavingThread::run() {
  for (;;) {
    struct pollfd event = {ends_[0], POLLIN, 0};
    poll(&event, 1, int(kInterval.count()));
    unsigned char byte = 0;
    const bool called = read(ends_[0], &byte, 1) == 1;
    save_(called && byte != 0 ? Clock::now() + kLastSave : Clock::time_point::max());
    if (!called) continue;
    if (byte == 0) return;
    endOnSignal(byte);
  }
}
