// Replays inputs of a fuzz target: every file in the folders named on the command line, in
// alphabetical order. Exit status 77 where there is none; a demand not met ends the process.
#include <algorithm>
#include <iterator>
#include <vector>

#include "fuzz.h"

namespace {

std::vector<std::string> filesIn(const std::string& folder) {
  std::vector<std::string> files;
  if (!std::filesystem::is_directory(folder)) return files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

void replay(const std::string& file) {
  std::printf("%s\n", file.c_str());
  std::fflush(stdout);
  std::ifstream in(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  const std::vector<std::uint8_t> data(bytes.begin(), bytes.end());
  LLVMFuzzerTestOneInput(data.data(), data.size());
}

}  // namespace

int main(int argc, char** argv) {
  std::size_t count = 0;
  for (int i = 1; i < argc; ++i) {
    for (const std::string& file : filesIn(argv[i])) {
      replay(file);
      ++count;
    }
  }
  return count > 0 ? 0 : 77;
}
