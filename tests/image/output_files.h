// What the tests of output files share: folders of their own, contents, processes of their own.
#pragma once
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "check.h"
#include "image/output_file.h"

namespace files {

/// A new, empty folder below the test output.
inline std::string emptyFolder(const std::string& name) {
  const std::string folder = check::temporaryFolder() + "/output_file_" + name;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

inline std::string contentOf(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

inline void put(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

inline void write(const std::string& path, const std::string& text) {
  writeFile(path, text.data(), text.size());
}

inline long entriesOf(const std::string& folder) {
  return std::distance(std::filesystem::directory_iterator(folder),
                       std::filesystem::directory_iterator());
}

/// The part of the message behind "PATH: cannot be written: " of the OutputError of `attempt`;
/// empty without one.
template <class Attempt>
std::string faultOf(const std::string& path, Attempt attempt) {
  try {
    attempt();
  } catch (const OutputError& error) {
    const std::string text = error.what();
    const std::string start = path + ": cannot be written: ";
    return text.rfind(start, 0) == 0 ? text.substr(start.size()) : "no path in: " + text;
  }
  return "";
}
inline std::string faultOf(const std::string& path) {
  return faultOf(path, [&path] { write(path, "new"); });
}
inline std::string earlyFaultOf(const std::string& path) {
  return faultOf(path, [&path] { checkOutput(path); });
}

inline unsigned permissionsOf(const std::string& path) {
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

}  // namespace files
