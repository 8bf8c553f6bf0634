// OutputFile: written beside its place, checked, renamed.
#include "image/output_file.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstdlib>
#include <cstring>

#include "image/temporary_names.h"

namespace {

constexpr int kMostLinks = 40;             // as Linux itself counts before it says ELOOP
constexpr std::size_t kLongestName = 255;  // of one part of a path, on every common file system

/// With its last slash; empty for a name in the current folder.
std::string folderOf(const std::string& path) { return path.substr(0, path.rfind('/') + 1); }

std::string canonical(const std::string& folder) {
  char* const found = realpath(folder.empty() ? "." : folder.c_str(), nullptr);
  const std::string result = found ? found : "";
  std::free(found);
  return result;
}

/// What a path stands for, once its links are followed.
struct Place {
  enum class Kind { file, inPlace, descriptor };
  Kind kind = Kind::file;
  std::string path;     // without links in its last part
  int descriptor = -1;  // of this process, where the kind says so
  bool exists = false;
  int error = 0;  // errno of why nobody can say whether it exists
  struct stat status = {};
};

/// True for /dev/fd/N, /proc/self/fd/N and the like: a descriptor of this very process.
bool namesOwnDescriptor(const std::string& path, const std::string& folder, Place& place) {
  const std::string name = path.substr(path.rfind('/') + 1);
  if (name.empty() || name.size() > 9) return false;
  if (name.find_first_not_of("0123456789") != std::string::npos) return false;
  const std::string own = "/proc/" + std::to_string(getpid()) + "/";
  const bool isOwn = folder == "/dev/fd" || folder == own + "fd" ||
                     (folder.rfind(own + "task/", 0) == 0 && folder.size() > 3 &&
                      folder.compare(folder.size() - 3, 3, "/fd") == 0);
  if (!isOwn) return false;
  place.kind = Place::Kind::descriptor;
  place.descriptor = std::stoi(name);
  return true;
}

/// The text of the symbolic link `path`; empty where it is none.
std::string linkText(const std::string& path) {
  char text[PATH_MAX];
  const ssize_t size = readlink(path.c_str(), text, sizeof text);
  return size <= 0 ? "" : std::string(text, static_cast<std::size_t>(size));
}

/// Follows the links of the last part by hand, because the file at their end may not exist yet.
/// Stops at /proc, whose links name things that may have no path: a pipe, a deleted file.
Place findPlace(const std::string& given) {
  Place place;
  place.path = given;
  if (given == "-") {
    place.kind = Place::Kind::descriptor;
    place.descriptor = STDOUT_FILENO;
    return place;
  }
  for (int links = 0; links <= kMostLinks; ++links) {
    const std::string folder = canonical(folderOf(place.path));
    if (namesOwnDescriptor(place.path, folder, place)) return place;
    const bool inProc = folder == "/proc" || folder.rfind("/proc/", 0) == 0;
    const std::string text = inProc ? "" : linkText(place.path);
    if (!text.empty()) {
      place.path = text[0] == '/' ? text : folderOf(place.path) + text;
      continue;
    }
    place.exists = stat(place.path.c_str(), &place.status) == 0;
    if (!place.exists && errno != ENOENT) place.error = errno;
    const bool isFile = !place.exists || S_ISREG(place.status.st_mode);
    if (inProc || !isFile) place.kind = Place::Kind::inPlace;
    return place;
  }
  throw OutputError(given, std::strerror(ELOOP));
}

/// 0, or the errno of what keeps the process from writing there.
int findObstacle(const Place& place) {
  const auto forbids = [](const std::string& path, int mode) {
    return faccessat(AT_FDCWD, path.c_str(), mode, AT_EACCESS) == 0 ? 0 : errno;
  };
  if (place.kind == Place::Kind::descriptor) {
    const int flags = fcntl(place.descriptor, F_GETFL);
    if (flags < 0) return errno;
    return (flags & O_ACCMODE) == O_RDONLY ? EBADF : 0;
  }
  if (place.path.empty()) return ENOENT;
  if (place.path.back() == '/') return EISDIR;
  if (place.error != 0) return place.error;
  if (place.exists) {
    if (S_ISDIR(place.status.st_mode)) return EISDIR;
    if (const int error = forbids(place.path, W_OK)) return error;
  }
  if (place.kind == Place::Kind::inPlace) return place.exists ? 0 : ENOENT;
  const std::string folder = folderOf(place.path);
  return forbids(folder.empty() ? "." : folder, W_OK | X_OK);
}

/// NAME.tmp.PID, NAME cut where the whole would be too long for a file system; from the second
/// attempt on (a file of that name was left by a killed run of the same number) with a counter.
std::string temporaryName(const std::string& target, int attempt) {
  std::string ending = ".tmp." + std::to_string(getpid());
  if (attempt > 1) ending += "." + std::to_string(attempt);
  const std::string folder = folderOf(target);
  return folder + target.substr(folder.size(), kLongestName - ending.size()) + ending;
}

int openInPlace(const Place& place) {
  if (place.kind == Place::Kind::descriptor) {
    return fcntl(place.descriptor, F_DUPFD_CLOEXEC, 0);
  }
  int descriptor = -1;
  do {
    descriptor = open(place.path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
  } while (descriptor < 0 && errno == EINTR);
  return descriptor;
}

/// Flushes to the disk. What cannot be flushed (a pipe, a device) is no error.
bool flush(int descriptor) {
  while (fsync(descriptor) != 0) {
    if (errno == EINTR) continue;
    return errno == EINVAL || errno == ENOTSUP || errno == EROFS;
  }
  return true;
}

/// Flushes the folder of a file, so that a rename in it outlives a power failure. A folder that may
/// be written but not read cannot be opened for that; the system flushes it in its own time.
bool flushFolderOf(const std::string& path) {
  const std::string folder = folderOf(path);
  const int descriptor = open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return errno == EACCES;
  const bool flushed = flush(descriptor);
  const int error = errno;
  close(descriptor);
  errno = error;
  return flushed;
}

/// True when the caller should try again what gave errno.
bool waitAndRetry(int descriptor) {
  if (errno == EINTR) return true;
  if (errno != EAGAIN && errno != EWOULDBLOCK) return false;
  struct pollfd event = {descriptor, POLLOUT, 0};  // someone made the pipe non-blocking
  return poll(&event, 1, -1) >= 0 || errno == EINTR;
}

}  // namespace

std::string outputTitle(const std::string& path) { return path == "-" ? "standard output" : path; }

OutputFile::OutputFile(const std::string& path) : path_(path) {
  const Place place = findPlace(path);
  if (const int error = findObstacle(place)) fail(error);
  if (place.kind != Place::Kind::file) {
    descriptor_ = openInPlace(place);
    if (descriptor_ < 0) fail(errno);
    return;
  }
  target_ = place.path;
  // 0600 until the old file's permissions are copied: it may be a private one.
  for (int attempt = 1; descriptor_ < 0 && attempt <= 100; ++attempt) {
    temporary_ = temporaryName(target_, attempt);
    descriptor_ = createTemporary(temporary_, place.exists ? 0600 : 0666, slot_);
    if (descriptor_ < 0 && errno != EEXIST) break;
  }
  if (descriptor_ < 0) fail(errno);
  if (!place.exists) return;
  // The owner first: a change of owner clears bits. Only root may, so a failure is no error.
  const bool owned = fchown(descriptor_, place.status.st_uid, place.status.st_gid) == 0;
  const mode_t kept = place.status.st_mode & (owned ? 07777 : 0777);
  if (fchmod(descriptor_, kept) != 0) {
    const int error = errno;
    removeTemporary();
    fail(error);
  }
}

OutputFile::~OutputFile() { removeTemporary(); }

void OutputFile::removeTemporary() {
  if (descriptor_ >= 0) close(descriptor_);
  descriptor_ = -1;
  if (slot_ < 0) return;
  unlink(temporary_.c_str());
  forgetTemporary(slot_);
  slot_ = -1;
}

void OutputFile::write(const void* data, std::size_t size) {
  const char* next = static_cast<const char*>(data);
  while (size > 0) {
    const std::size_t part = std::min<std::size_t>(size, SSIZE_MAX);
    const ssize_t written = ::write(descriptor_, next, part);
    if (written == 0) fail(EIO);
    if (written < 0) {
      if (!waitAndRetry(descriptor_)) fail(errno);
      continue;
    }
    next += written;
    size -= static_cast<std::size_t>(written);
    size_ += static_cast<std::size_t>(written);
  }
}

void OutputFile::checkSize() const {
  struct stat status = {};
  if (fstat(descriptor_, &status) != 0) fail(errno);
  if (static_cast<std::size_t>(status.st_size) != size_) fail(EIO);
}

void OutputFile::commit() {
  if (!flush(descriptor_)) fail(errno);
  if (slot_ >= 0) checkSize();
  const int closing = descriptor_;
  descriptor_ = -1;
  // After EINTR the descriptor is closed all the same on Linux, and the bytes are flushed.
  if (close(closing) != 0 && errno != EINTR) fail(errno);
  if (slot_ < 0) return;
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
  forgetTemporary(slot_);
  slot_ = -1;
  if (!flushFolderOf(target_)) fail(errno);
}

void OutputFile::fail(int error) const {
  waitIfEnding();
  throw OutputError(path_, std::strerror(error));
}

void writeFile(const std::string& path, const void* data, std::size_t size) {
  OutputFile file(path);
  file.write(data, size);
  file.commit();
}

void checkOutput(const std::string& path) {
  if (const int error = findObstacle(findPlace(path))) {
    throw OutputError(path, std::strerror(error));
  }
}
