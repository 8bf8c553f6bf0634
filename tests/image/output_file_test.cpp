// OutputFile: the old file or the whole new one, and no litter.
#include "image/output_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <thread>
#include <vector>

#include "check.h"
#include "output_files.h"

namespace fs = std::filesystem;
using files::contentOf;
using files::emptyFolder;
using files::entriesOf;
using files::inProcess;
using files::permissionsOf;
using files::put;
using files::write;

namespace {
constexpr unsigned kNobody = 65534;
}

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
