// SavingThread: saves from time to time, and once more when a signal asks the program to end.
#pragma once
#include <chrono>
#include <functional>
#include <thread>

class SavingThread {
 public:
  using Clock = std::chrono::steady_clock;
  /// Saves what there is to save, but starts on nothing after the deadline. Must not throw.
  using Save = std::function<void(Clock::time_point deadline)>;

  /// Calls save every `kInterval` from now on, on a thread of its own. A signal that asks the
  /// program to end (see removeTemporaryOnSignals) calls it once more, for `kLastSave` at most, and
  /// ends the program. Only one such thread may be there at a time. Throws std::system_error.
  explicit SavingThread(Save save);
  /// Calls save for the last time, without a deadline; signals end the program at once again.
  ~SavingThread();
  SavingThread(const SavingThread&) = delete;
  SavingThread& operator=(const SavingThread&) = delete;

  /// Far below the 5 s of work that may be lost, so that little has to be saved when the program
  /// is asked to end.
  static constexpr std::chrono::milliseconds kInterval{500};
  /// The program is to end within 100 ms.
  static constexpr std::chrono::milliseconds kLastSave{50};

 private:
  void run();

  const Save save_;
  int ends_[2] = {-1, -1};  // of a pipe: the numbers of signals, or 0 to come to an end
  std::thread thread_;
};
