// Starting processes with posix_spawn, which does not copy the benchmark's own page tables.
#include "process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

extern char** environ;

namespace bench {
namespace {

class FileActions {
 public:
  explicit FileActions(const std::string& outputFile) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, 1, outputFile.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                     0644);
  }
  ~FileActions() { posix_spawn_file_actions_destroy(&actions_); }
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;
  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_;
};

/// The number of kB behind `name` in /proc/self/status, in bytes.
double statusBytes(const std::string& name) {
  std::ifstream status("/proc/self/status");
  std::string word;
  double value = 0;
  while (status >> word) {
    if (word == name && status >> value) return value * 1024;
  }
  throw std::runtime_error("/proc/self/status: no " + name);
}

}  // namespace

Run runProcess(const std::vector<std::string>& words, const std::string& outputFile) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const FileActions actions(outputFile);
  const auto start = std::chrono::steady_clock::now();
  pid_t child = 0;
  const int error =
      posix_spawn(&child, arguments[0], actions.get(), nullptr, arguments.data(), environ);
  if (error != 0) throw std::runtime_error(words[0] + ": " + std::strerror(error));
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  if (status != 0) throw std::runtime_error(words[0] + ": failed");
  return {taken.count(), double(usage.ru_maxrss) * 1024};
}

Run runFresh(const std::vector<std::string>& words, const std::string& outputFile) {
  std::vector<std::string> all = {ownProgram(), "_child", "run", outputFile};
  all.insert(all.end(), words.begin(), words.end());
  const std::string line = outputOf(all);
  Run run;
  if (std::sscanf(line.c_str(), "%lf %lf", &run.seconds, &run.peakBytes) != 2) {
    throw std::runtime_error("expected seconds and bytes, found: " + line);
  }
  return run;
}

std::string outputOf(const std::vector<std::string>& words) {
  const ScratchFolder scratch;
  runProcess(words, scratch.file("output"));
  std::ifstream in(scratch.file("output"));
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::string ownProgram() { return std::filesystem::read_symlink("/proc/self/exe").string(); }

double startPeakMemory() {
  std::ofstream("/proc/self/clear_refs") << "5";
  return statusBytes("VmRSS:");
}

double peakMemory() { return statusBytes("VmHWM:"); }

ScratchFolder::ScratchFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "raytracer_bench.XXXXXX").string();
  if (!mkdtemp(name.data())) throw std::runtime_error(name + ": cannot be made");
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace bench
