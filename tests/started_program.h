// The real program, started and still running, so that signals can reach it.
#pragma once
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <string>

#include "run_program.h"

namespace check {

class StartedProgram {
 public:
  /// As runProgram, but does not wait. What it says goes to the file "said" in the folder.
  StartedProgram(const std::string& arguments, const std::string& folder)
      : command_("cd " + quoted(folder) + " && exec " + quoted(check::programToTest()) + " " +
                 arguments + " 2>>said"),
        pid_(fork()) {
    if (pid_ != 0) return;
    for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, SIG_DFL);
    execl("/bin/sh", "sh", "-c", command_.c_str(), static_cast<char*>(nullptr));
    _exit(127);
  }
  ~StartedProgram() {
    if (isRunning()) end(SIGKILL);
  }
  StartedProgram(const StartedProgram&) = delete;
  StartedProgram& operator=(const StartedProgram&) = delete;

  bool isRunning() {
    if (status_ < 0) take(waitpid(pid_, &result_, WNOHANG));
    return status_ < 0;
  }
  /// Waits for the end and gives the exit status, 128 + the signal's number where one ended it.
  int wait() {
    while (status_ < 0) take(waitpid(pid_, &result_, 0));
    return status_;
  }
  /// Sends a signal and waits for the end.
  int end(int signal) {
    const auto start = std::chrono::steady_clock::now();
    kill(pid_, signal);
    const int status = wait();
    milliseconds_ =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return status;
  }
  /// Sends a signal, and SIGKILL where it has not ended the program after so many milliseconds.
  void endWithin(int milliseconds, int signal) {
    kill(pid_, signal);
    for (; milliseconds > 0 && isRunning(); --milliseconds) usleep(1000);
    if (isRunning()) end(SIGKILL);
  }
  /// How long the last end() took.
  double milliseconds() const { return milliseconds_; }

 private:
  void take(pid_t ended) {
    if (ended == pid_) {
      status_ = WIFEXITED(result_) ? WEXITSTATUS(result_) : 128 + WTERMSIG(result_);
    }
  }

  const std::string command_;
  const pid_t pid_;
  int result_ = 0, status_ = -1;  // -1: still running
  double milliseconds_ = 0;
};

inline void sleepMilliseconds(double time) { usleep(useconds_t(time * 1000)); }

}  // namespace check
