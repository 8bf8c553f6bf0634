// OutputFile: the old file or the whole new one, and no litter.
#include "image/output_file.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>
#include <vector>

#include "check.h"

namespace fs = std::filesystem;

namespace {

/// A new, empty folder below the test output.
std::string emptyFolder(const std::string& name) {
  const std::string folder = check::temporaryFolder() + "/output_file_" + name;
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

std::string contentOf(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

void put(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

void write(const std::string& path, const std::string& text) {
  writeFile(path, text.data(), text.size());
}

long entriesOf(const std::string& folder) {
  return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

/// The part of the message behind "PATH: "; empty when the file is written.
std::string faultOf(const std::string& path) {
  try {
    write(path, "new");
  } catch (const OutputError& error) {
    const std::string text = error.what();
    return text.rfind(path + ": ", 0) == 0 ? text.substr(path.size() + 2) : "no path in: " + text;
  }
  return "";
}

std::string earlyFaultOf(const std::string& path) {
  try {
    checkOutput(path);
  } catch (const OutputError& error) {
    const std::string text = error.what();
    return text.rfind(path + ": ", 0) == 0 ? text.substr(path.size() + 2) : "no path in: " + text;
  }
  return "";
}

unsigned permissionsOf(const std::string& path) {
  struct stat status = {};
  stat(path.c_str(), &status);
  return status.st_mode & 07777;
}

/// Runs `work` in a process of its own and gives what waitpid says of its end; 0 is success.
template <class Work>
int inProcess(Work work) {
  const pid_t child = fork();
  if (child == 0) {
    int status = 99;
    try {
      status = work();
    } catch (...) {
    }
    _exit(status);
  }
  int status = -1;
  waitpid(child, &status, 0);
  return status;
}

constexpr unsigned kNobody = 65534;

/// As inProcess, without root's right to write everywhere.
template <class Work>
int asPlainUser(Work work) {
  return inProcess([&work] {
    if (geteuid() == 0 && (setgid(kNobody) != 0 || setuid(kNobody) != 0)) return 98;
    return work();
  });
}

}  // namespace

TEST("a new file is written with the permissions that the umask leaves") {
  const std::string folder = emptyFolder("new");
  const mode_t before = umask(027);
  write(folder + "/a", "hello");
  umask(before);
  CHECK_EQUAL(contentOf(folder + "/a"), "hello");
  CHECK_EQUAL(permissionsOf(folder + "/a"), 0640u);  // 0666 & ~027
  CHECK_EQUAL(entriesOf(folder), 1);
}

TEST("an empty file and one of many writes are written whole") {
  const std::string folder = emptyFolder("sizes");
  write(folder + "/empty", "");
  CHECK(fs::exists(folder + "/empty"));
  CHECK_EQUAL(contentOf(folder + "/empty"), "");
  std::string expected;
  OutputFile file(folder + "/parts");
  for (int i = 0; i < 1000; ++i) {
    const std::string part = std::to_string(i) + " ";
    expected += part;
    file.write(part.data(), part.size());
  }
  file.commit();
  CHECK_EQUAL(contentOf(folder + "/parts"), expected);
}

TEST("until commit the old file stays, and the new one stands beside it as NAME.tmp.PID") {
  const std::string folder = emptyFolder("beside"), path = folder + "/a";
  put(path, "old");
  OutputFile file(path);
  file.write("new", 3);
  CHECK_EQUAL(contentOf(path), "old");
  const std::string temporary = path + ".tmp." + std::to_string(getpid());
  CHECK_EQUAL(contentOf(temporary), "new");
  file.commit();
  CHECK_EQUAL(contentOf(path), "new");
  CHECK_EQUAL(entriesOf(folder), 1);
}

TEST("without commit the old file stays and nothing is left") {
  const std::string folder = emptyFolder("dropped"), path = folder + "/a";
  put(path, "old");
  {
    OutputFile file(path);
    file.write("new", 3);
    OutputFile other(folder + "/b");
    other.write("new", 3);
  }
  CHECK_EQUAL(contentOf(path), "old");
  CHECK_EQUAL(entriesOf(folder), 1);
}

TEST("a replaced file keeps its permission bits and owner") {
  const std::string folder = emptyFolder("permissions"), path = folder + "/a";
  for (const unsigned bits : {0600u, 0666u, 0755u, 0640u}) {
    put(path, "old");
    chmod(path.c_str(), bits);
    write(path, "new");
    CHECK_EQUAL(permissionsOf(path), bits);
    CHECK_EQUAL(contentOf(path), "new");
  }
  if (geteuid() == 0) {
    CHECK_EQUAL(chown(path.c_str(), kNobody, kNobody), 0);
    write(path, "newer");
    struct stat status = {};
    CHECK_EQUAL(stat(path.c_str(), &status), 0);
    CHECK_EQUAL(status.st_uid, kNobody);
    CHECK_EQUAL(status.st_gid, kNobody);
  }
}

TEST("a symbolic link stays, and the file that it points to is replaced") {
  const std::string folder = emptyFolder("links");
  fs::create_directories(folder + "/deep/er");
  put(folder + "/deep/target", "old");
  fs::create_symlink("../target", folder + "/deep/er/second");  // seen from its own folder
  fs::create_symlink(folder + "/deep/er/second", folder + "/first");
  checkOutput(folder + "/first");
  write(folder + "/first", "new");
  CHECK(fs::is_symlink(folder + "/first"));
  CHECK(fs::is_symlink(folder + "/deep/er/second"));
  CHECK(!fs::is_symlink(folder + "/deep/target"));
  CHECK_EQUAL(contentOf(folder + "/deep/target"), "new");
}

TEST("a symbolic link to a file that is not there yet creates that file") {
  const std::string folder = emptyFolder("dangling");
  fs::create_symlink("target", folder + "/link");
  write(folder + "/link", "new");
  CHECK(fs::is_symlink(folder + "/link"));
  CHECK_EQUAL(contentOf(folder + "/target"), "new");
  CHECK_EQUAL(entriesOf(folder), 2);
}

TEST("links in a circle are an error") {
  const std::string folder = emptyFolder("circle");
  fs::create_symlink("b", folder + "/a");
  fs::create_symlink("a", folder + "/b");
  CHECK_EQUAL(faultOf(folder + "/a"), "Too many levels of symbolic links");
  CHECK_EQUAL(earlyFaultOf(folder + "/a"), "Too many levels of symbolic links");
}

TEST("a missing folder, a folder, and an empty name are errors, early and late") {
  const std::string folder = emptyFolder("missing");
  put(folder + "/file", "old");
  const std::pair<std::string, std::string> cases[] = {
      {folder + "/no/a", "No such file or directory"},
      {"", "No such file or directory"},
      {folder, "Is a directory"},
      {folder + "/", "Is a directory"},
      {folder + "/no/", "Is a directory"},
      {folder + "/.", "Is a directory"},
      {".", "Is a directory"},
      {folder + "/file/a", "Not a directory"},
      {"/dev/fd/987", "Bad file descriptor"},
      {"/proc/no_such_entry", "No such file or directory"}};
  for (const auto& [path, expected] : cases) {
    CHECK_EQUAL(faultOf(path), expected);
    CHECK_EQUAL(earlyFaultOf(path), expected);
  }
  CHECK_EQUAL(entriesOf(folder), 1);
  CHECK_EQUAL(contentOf(folder + "/file"), "old");
}

TEST("a name in the current folder needs no slash") {
  const std::string folder = emptyFolder("current");
  const fs::path before = fs::current_path();
  fs::current_path(folder);
  checkOutput("a");
  write("a", "new");
  fs::current_path(before);
  CHECK_EQUAL(contentOf(folder + "/a"), "new");
}

TEST("checkOutput creates nothing and keeps what is there") {
  const std::string folder = emptyFolder("early");
  checkOutput(folder + "/a");
  CHECK_EQUAL(entriesOf(folder), 0);
  put(folder + "/a", "old");
  checkOutput(folder + "/a");
  CHECK_EQUAL(contentOf(folder + "/a"), "old");
}

TEST("a folder or file without write permission is an error, early and late") {
  // In /tmp: a plain user may have no way into the folder of the other tests.
  char folder[] = "/tmp/output_file_test_XXXXXX";
  CHECK(mkdtemp(folder) != nullptr);
  chmod(folder, 0777);
  const std::string locked = std::string(folder) + "/locked", file = std::string(folder) + "/file";
  fs::create_directories(locked);
  put(file, "old");
  chmod(locked.c_str(), 0555);
  chmod(file.c_str(), 0444);
  const int status = asPlainUser([&] {
    const std::string denied = "Permission denied";
    return (faultOf(locked + "/a") == denied ? 0 : 1) +
           (earlyFaultOf(locked + "/a") == denied ? 0 : 2) + (faultOf(file) == denied ? 0 : 4) +
           (earlyFaultOf(file) == denied ? 0 : 8) +
           (faultOf(std::string(folder) + "/fine").empty() ? 0 : 16);
  });
  CHECK_EQUAL(WEXITSTATUS(status), 0);
  CHECK_EQUAL(contentOf(file), "old");
  fs::remove_all(folder);
}

TEST("a full device reports an error") {
  if (!fs::exists("/dev/full")) SKIP("no /dev/full");
  checkOutput("/dev/full");
  CHECK_EQUAL(faultOf("/dev/full"), "No space left on device");
  CHECK(fs::is_character_file("/dev/full"));
  CHECK_EQUAL(faultOf("/dev/null"), "");
  CHECK(fs::is_character_file("/dev/null"));
}

TEST("a symbolic link to a device is written in place") {
  if (!fs::exists("/dev/full")) SKIP("no /dev/full");
  const std::string folder = emptyFolder("device_link");
  fs::create_symlink("/dev/full", folder + "/link");
  CHECK_EQUAL(faultOf(folder + "/link"), "No space left on device");
  CHECK_EQUAL(entriesOf(folder), 1);
}

TEST("a FIFO is written in place") {
  const std::string folder = emptyFolder("fifo"), path = folder + "/pipe";
  CHECK_EQUAL(mkfifo(path.c_str(), 0600), 0);
  checkOutput(path);  // does not wait for a reader
  std::string expected;
  for (int i = 0; i < 50000; ++i) expected += std::to_string(i) + " ";  // more than a pipe holds
  std::string read;
  std::thread reader([&] { read = contentOf(path); });
  write(path, expected);
  reader.join();
  CHECK(read == expected);
  CHECK(fs::is_fifo(path));
  CHECK_EQUAL(entriesOf(folder), 1);
}

TEST("/dev/stdout and descriptors are written in place, from where they stand") {
  if (!fs::exists("/proc/self/fd")) SKIP("no /proc/self/fd");
  const std::string folder = emptyFolder("descriptor"), path = folder + "/a";
  const int status = inProcess([&] {
    const int file = open(path.c_str(), O_WRONLY | O_CREAT, 0600);
    dup2(file, 1);
    const std::string number = std::to_string(file);
    for (const std::string& name : {std::string("/dev/stdout"), "/dev/fd/" + number,
                                    "/proc/self/fd/" + number, folder + "/link"}) {
      if (name == folder + "/link") fs::create_symlink("/dev/stdout", name);
      checkOutput(name);
      write(name, name + "\n");
    }
    return ::write(1, "end", 3) == 3 ? 0 : 1;  // still open
  });
  CHECK_EQUAL(status, 0);
  const std::string text = contentOf(path);
  CHECK(text.rfind("/dev/stdout\n/dev/fd/", 0) == 0);
  CHECK(text.find("/proc/self/fd/") != std::string::npos);
  CHECK(text.find(folder + "/link\nend") != std::string::npos);
  CHECK_EQUAL(entriesOf(folder), 2);
}

TEST("a pipe that was made non-blocking is waited for") {
  int ends[2] = {};
  CHECK_EQUAL(pipe(ends), 0);
  fcntl(ends[1], F_SETFL, O_NONBLOCK);
  const std::string expected(300000, 'x');
  std::string read;
  std::thread reader([&] {
    char part[4096];
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    while (read.size() < expected.size()) {
      const ssize_t count = ::read(ends[0], part, sizeof part);
      if (count <= 0) break;
      read.append(part, std::size_t(count));
    }
  });
  write("/dev/fd/" + std::to_string(ends[1]), expected);
  reader.join();
  CHECK(read == expected);
  close(ends[0]);
  close(ends[1]);
}

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
      return error.what() == path + ": File too large" ? 0 : 2;
    }
    return 1;
  });
  CHECK_EQUAL(WEXITSTATUS(status), 0);
  CHECK(WIFEXITED(status));
  CHECK_EQUAL(contentOf(path), "old");
  CHECK_EQUAL(entriesOf(folder), 1);
}

TEST("a rename that fails is an error and leaves no litter") {
  const std::string folder = emptyFolder("rename"), path = folder + "/a";
  {
    OutputFile file(path);
    file.write("new", 3);
    fs::create_directories(path);  // a folder has taken the name meanwhile
    CHECK_THROWS((file.commit(), 0), OutputError);
  }
  CHECK(fs::is_directory(path));
  CHECK_EQUAL(entriesOf(folder), 1);
}

TEST("two writers of one name each leave a whole file") {
  const std::string folder = emptyFolder("two"), path = folder + "/a";
  OutputFile first(path), second(path);  // the second one finds the first one's temporary name
  first.write("fir", 3);
  second.write("second", 6);
  first.write("st", 2);
  first.commit();
  CHECK_EQUAL(contentOf(path), "first");
  second.commit();
  CHECK_EQUAL(contentOf(path), "second");
  CHECK_EQUAL(entriesOf(folder), 1);
}

TEST("two processes that write one name leave a whole file at every moment") {
  const std::string folder = emptyFolder("processes"), path = folder + "/a";
  const std::string whole[] = {std::string(50000, 'x'), std::string(70000, 'y')};
  write(path, whole[0]);
  std::atomic<int> running{2};
  std::vector<std::thread> writers;
  std::atomic<int> failures{0};
  for (const std::string& text : whole) {
    writers.emplace_back([&] {
      const int status = inProcess([&] {
        for (int i = 0; i < 20; ++i) write(path, text);
        return 0;
      });
      if (status != 0) ++failures;
      --running;
    });
  }
  int looks = 0, broken = 0;
  while (running > 0) {
    const std::string found = contentOf(path);
    ++looks;
    if (found != whole[0] && found != whole[1]) ++broken;
  }
  for (std::thread& writer : writers) writer.join();
  CHECK(looks > 0);
  CHECK_EQUAL(broken, 0);
  CHECK_EQUAL(failures.load(), 0);
  CHECK_EQUAL(entriesOf(folder), 1);
}

TEST("a long name has room for the temporary one") {
  const std::string folder = emptyFolder("long"), path = folder + "/" + std::string(255, 'n');
  write(path, "new");
  CHECK_EQUAL(contentOf(path), "new");
  CHECK_EQUAL(faultOf(path + "n"), "File name too long");
  CHECK_EQUAL(earlyFaultOf(path + "n"), "File name too long");
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
