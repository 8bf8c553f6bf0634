// OutputFile: signals and limits leave the old file and no litter.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "check.h"
#include "image/output_file.h"
#include "image/picture_file.h"
#include "output_files.h"

namespace fs = std::filesystem;
using files::contentOf;
using files::emptyFolder;
using files::entriesOf;
using files::inProcess;
using files::put;
using files::write;

TEST("a write that fails half way leaves the old file and no litter") {
  const std::string folder = emptyFolder("limit"), path = folder + "/a";
  put(path, "old");
  const int status = inProcess([&] {
    removeTemporaryOnSignals();  // ignores SIGXFSZ
    const rlimit limit = {1000, 1000};
    setrlimit(RLIMIT_FSIZE, &limit);
    try {
      write(path, std::string(5000, 'n'));
    } catch (const OutputError& error) {
      return error.what() == path + ": cannot be written: File too large" ? 0 : 2;
    }
    return 1;
  });
  CHECK_EQUAL(WEXITSTATUS(status), 0);
  CHECK(WIFEXITED(status));
  CHECK_EQUAL(contentOf(path), "old");
  CHECK_EQUAL(entriesOf(folder), 1);
}

TEST("a signal that ends the program removes every temporary file") {
  const std::string folder = emptyFolder("signals"), path = folder + "/a";
  put(path, "old");
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) {
    const int status = inProcess([&] {
      std::signal(signal, SIG_DFL);
      removeTemporaryOnSignals();
      OutputFile file(path), other(folder + "/b");
      file.write("new", 3);
      if (entriesOf(folder) != 3) return 1;
      kill(getpid(), signal);
      pause();
      return 2;
    });
    CHECK(WIFEXITED(status));
    CHECK_EQUAL(WEXITSTATUS(status), 128 + signal);
    CHECK_EQUAL(contentOf(path), "old");
    CHECK_EQUAL(entriesOf(folder), 1);
  }
}

TEST("a crash removes the temporary file and is still a crash") {
  const std::string folder = emptyFolder("crash");
  const int status = inProcess([&] {
    const rlimit none = {0, 0};
    setrlimit(RLIMIT_CORE, &none);
    removeTemporaryOnSignals();
    OutputFile file(folder + "/a");
    std::abort();
    return 0;
  });
  CHECK(WIFSIGNALED(status));
  CHECK_EQUAL(WTERMSIG(status), SIGABRT);
  CHECK_EQUAL(entriesOf(folder), 0);
}

TEST("a signal that was ignored stays ignored") {
  const std::string folder = emptyFolder("ignored");
  const int status = inProcess([&] {
    std::signal(SIGHUP, SIG_IGN);  // as nohup does
    removeTemporaryOnSignals();
    OutputFile file(folder + "/a");
    kill(getpid(), SIGHUP);
    file.write("new", 3);
    file.commit();
    return 0;
  });
  CHECK_EQUAL(status, 0);
  CHECK_EQUAL(contentOf(folder + "/a"), "new");
}

TEST("a signal at any moment leaves the old file or the whole new one, and no litter") {
  const std::string folder = emptyFolder("any_moment"), path = folder + "/a";
  put(path, "old");
  const std::string whole(20000, 'n');
  for (int round = 0; round < 60; ++round) {
    const pid_t child = fork();
    if (child == 0) {
      std::signal(SIGTERM, SIG_DFL);
      removeTemporaryOnSignals();
      std::thread other([&] {
        for (;;) write(folder + "/b", whole);
      });
      for (;;) write(path, whole);
    }
    usleep(useconds_t(3000 + 97 * round));
    kill(child, SIGTERM);
    int status = -1;
    waitpid(child, &status, 0);
    // 143 from the handler, or the plain signal where it came before the handler was there.
    CHECK(WIFEXITED(status) ? WEXITSTATUS(status) == 128 + SIGTERM : WTERMSIG(status) == SIGTERM);
    const std::string found = contentOf(path);
    CHECK(found == "old" || found == whole);
    for (const auto& entry : fs::directory_iterator(folder)) {
      CHECK(entry.path().filename() == "a" || entry.path().filename() == "b");
    }
  }
}

TEST("a picture is written without a second copy of it in memory") {
  const int status = inProcess([] {
    const Image image(6000, 6000);  // 108 MB, against 32 MB more than is in use
    std::ifstream statistics("/proc/self/statm");
    rlim_t pages = 0;
    if (!(statistics >> pages)) return 77;
    const rlim_t room = pages * rlim_t(sysconf(_SC_PAGESIZE)) + (rlim_t{32} << 20);
    const rlimit limit = {room, room};
    setrlimit(RLIMIT_AS, &limit);
    writePicture(image, "/dev/null");
    return 0;
  });
  if (WEXITSTATUS(status) == 77) SKIP("the memory in use cannot be asked here");
  CHECK_EQUAL(WEXITSTATUS(status), 0);
}
