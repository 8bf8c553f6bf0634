// Bytes: reads a whole file.
#include "image/bytes.h"

#include <sys/stat.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

namespace {

// A device such as /dev/zero never ends.
constexpr std::size_t kMostOfDevice = std::size_t{64} << 20;
constexpr std::size_t kMostStreamed = std::size_t{1} << 30;

struct Closer {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

}  // namespace

Bytes readBytes(const std::string& path) {
  const std::unique_ptr<std::FILE, Closer> file(std::fopen(path.c_str(), "rb"));
  if (!file) throw ImageError(path, std::strerror(errno));
  struct stat status = {};
  const bool isFile = fstat(fileno(file.get()), &status) == 0 && S_ISREG(status.st_mode);
  Bytes bytes;
  std::size_t count = 1;
  while (count > 0) {
    constexpr std::size_t kStep = 65536;
    const std::size_t before = bytes.size();
    if (S_ISCHR(status.st_mode) && before > kMostOfDevice) {
      throw ImageError(path, "expected at most 64 MB from a device, found more");
    }
    if (!isFile && before > kMostStreamed) {
      throw ImageError(path, "expected at most 1 GiB from what is no plain file, found more");
    }
    bytes.resize(before + kStep);
    count = std::fread(bytes.data() + before, 1, kStep, file.get());
    bytes.resize(before + count);
  }
  if (std::ferror(file.get())) throw ImageError(path, std::strerror(errno));
  return bytes;
}
