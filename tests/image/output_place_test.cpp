// OutputFile: links, folders, devices, FIFOs, descriptors, and what is known early.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <stdexcept>
#include <thread>

#include "check.h"
#include "image/output_file.h"
#include "output_files.h"

namespace fs = std::filesystem;
using files::contentOf;
using files::earlyFaultOf;
using files::emptyFolder;
using files::entriesOf;
using files::faultOf;
using files::inProcess;
using files::put;
using files::write;

namespace {

constexpr unsigned kNobody = 65534;

/// As inProcess, without root's right to write everywhere.
template <class Work>
int asPlainUser(Work work) {
  return inProcess([&work] {
    if (geteuid() == 0 && (setgid(kNobody) != 0 || setuid(kNobody) != 0)) return 98;
    return work();
  });
}

/// A new folder that any user can write to; in /tmp, because the folders above the other tests'
/// may be closed to plain users. The caller removes it.
std::string openFolder() {
  char folder[] = "/tmp/output_place_test_XXXXXX";
  if (mkdtemp(folder) == nullptr) throw std::runtime_error("cannot make a folder in /tmp");
  chmod(folder, 0777);
  return folder;
}

}  // namespace

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
  const std::string target = (fs::canonical(folder) / "target").string();
  CHECK_EQUAL(outputTarget(folder + "/link"), target);
  write(folder + "/link", "new");
  CHECK_EQUAL(outputTarget(folder + "/link"), target);
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
  const std::string target = outputTarget(folder + "/a");  // one of them, and no error
  CHECK_EQUAL(fs::path(target).parent_path(), fs::canonical(folder));
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
  const std::string folder = openFolder();
  const std::string locked = folder + "/locked", file = folder + "/file";
  fs::create_directories(locked);
  put(file, "old");
  chmod(locked.c_str(), 0555);
  chmod(file.c_str(), 0444);
  const int status = asPlainUser([&] {
    const std::string denied = "Permission denied";
    return (faultOf(locked + "/a") == denied ? 0 : 1) +
           (earlyFaultOf(locked + "/a") == denied ? 0 : 2) + (faultOf(file) == denied ? 0 : 4) +
           (earlyFaultOf(file) == denied ? 0 : 8) + (faultOf(folder + "/fine").empty() ? 0 : 16);
  });
  CHECK_EQUAL(WEXITSTATUS(status), 0);
  CHECK_EQUAL(contentOf(file), "old");
  fs::remove_all(folder);
}

// As root, a writer that is broken would replace the machine's own devices: hence asPlainUser
// wherever a test names one.

TEST("a full device reports an error, and devices are written in place") {
  if (!fs::exists("/dev/full")) SKIP("no /dev/full");
  const int status = asPlainUser([] {
    return (earlyFaultOf("/dev/full").empty() ? 0 : 1) +
           (faultOf("/dev/full") == "No space left on device" ? 0 : 2) +
           (faultOf("/dev/null").empty() ? 0 : 4);
  });
  CHECK_EQUAL(status, 0);
  CHECK(fs::is_character_file("/dev/full"));
  CHECK(fs::is_character_file("/dev/null"));
}

TEST("a symbolic link to a device is written in place") {
  if (!fs::exists("/dev/full")) SKIP("no /dev/full");
  const std::string folder = openFolder(), link = folder + "/link";
  fs::create_symlink("/dev/full", link);
  const int status =
      asPlainUser([&] { return faultOf(link) == "No space left on device" ? 0 : 1; });
  CHECK_EQUAL(status, 0);
  CHECK(fs::is_symlink(link));
  CHECK_EQUAL(entriesOf(folder), 1);
  fs::remove_all(folder);
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
  const std::string folder = openFolder(), path = folder + "/a";
  const int status = asPlainUser([&] {
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
  fs::remove_all(folder);
}

TEST("a pipe that was made non-blocking is waited for") {
  int ends[2] = {};
  CHECK_EQUAL(pipe(ends), 0);
  fcntl(ends[1], F_SETFL, O_NONBLOCK);
  std::string expected;
  for (int i = 0; i < 50000; ++i) expected += std::to_string(i) + " ";  // more than a pipe holds
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

TEST("a long name has room for the temporary one") {
  const std::string folder = emptyFolder("long"), path = folder + "/" + std::string(255, 'n');
  write(path, "new");
  CHECK_EQUAL(contentOf(path), "new");
  CHECK_EQUAL(faultOf(path + "n"), "File name too long");
  CHECK_EQUAL(earlyFaultOf(path + "n"), "File name too long");
  CHECK_EQUAL(entriesOf(folder), 1);
}
