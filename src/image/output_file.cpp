// OutputFile: written beside its place, checked, renamed.
// First the place is found: what the name stands for once its links are followed. A plain file, or
// one that is not there yet, is written under a temporary name in the same folder, because a rename
// is one step only within a file system, and flushed to the disk before the rename, so that after a
// power failure the name stands for the whole old file or the whole new one. Anything else is
// written where it is. What keeps the process from writing is found before anything is created, by
// the same function for checkOutput and OutputFile.
#include "image/output_file.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstring>
#include <filesystem>

namespace {

namespace fs = std::filesystem;

constexpr int kMostLinks = 40;             // as Linux itself counts before it says ELOOP
constexpr int kMostAttempts = 100;         // to find a temporary name that is free
constexpr std::size_t kLongestName = 255;  // of one part of a path, on every common file system

/// With its last slash; empty for a name in the current folder.
std::string folderOf(const std::string& path) { return path.substr(0, path.rfind('/') + 1); }
/// The same as the system takes it.
std::string openFolderOf(const std::string& path) {
  return folderOf(path).empty() ? "." : folderOf(path);
}

/// What a path stands for, once its links are followed.
struct Place {
  std::string path;     // without links in its last part
  int descriptor = -1;  // of this process, where the path stands for one
  bool isInPlace = false;
  bool exists = false;
  int error = 0;  // errno of why nobody can say whether it exists
  struct stat status = {};
};

/// True for /dev/fd, /proc/self/fd and the like: the descriptors of this very process.
bool holdsOwnDescriptors(const std::string& folder) {
  const std::string own = "/proc/" + std::to_string(getpid()) + "/";
  const bool isOfThread = folder.rfind(own + "task/", 0) == 0 && folder.size() > 3 &&
                          folder.compare(folder.size() - 3, 3, "/fd") == 0;
  return folder == "/dev/fd" || folder == own + "fd" || isOfThread;
}

/// Follows the links of the last part by hand, because the file at their end may not exist yet.
/// Stops at /proc, whose links name things that may have no path: a pipe, a deleted file.
Place findPlace(const std::string& given) {
  Place place;
  place.path = given == "-" ? "/dev/fd/" + std::to_string(STDOUT_FILENO) : given;
  for (int links = 0; links <= kMostLinks; ++links) {
    std::error_code ignored;
    const std::string folder = fs::canonical(openFolderOf(place.path), ignored).string();
    const std::string name = place.path.substr(folderOf(place.path).size());
    const bool isNumber = !name.empty() && name.size() <= 9 &&
                          name.find_first_not_of("0123456789") == std::string::npos;
    if (given == "-" || (isNumber && holdsOwnDescriptors(folder))) {
      place.isInPlace = true;
      place.descriptor = std::stoi(name);
      return place;
    }
    const bool isInProc = folder == "/proc" || folder.rfind("/proc/", 0) == 0;
    const std::string text = isInProc ? "" : fs::read_symlink(place.path, ignored).string();
    if (!text.empty()) {
      place.path = text[0] == '/' ? text : folderOf(place.path) + text;
      continue;
    }
    place.exists = stat(place.path.c_str(), &place.status) == 0;
    if (!place.exists && errno != ENOENT) place.error = errno;
    place.isInPlace = isInProc || (place.exists && !S_ISREG(place.status.st_mode));
    return place;
  }
  throw OutputError(given, std::strerror(ELOOP));
}

/// 0, or the errno of why the process may not use the path so.
int errorOfAccess(const std::string& path, int mode) {
  return faccessat(AT_FDCWD, path.c_str(), mode, AT_EACCESS) == 0 ? 0 : errno;
}

/// 0, or the errno of what keeps the process from writing there.
int findObstacle(const Place& place) {
  if (place.descriptor >= 0) {
    const int flags = fcntl(place.descriptor, F_GETFL);
    if (flags < 0) return errno;
    return (flags & O_ACCMODE) == O_RDONLY ? EBADF : 0;
  }
  if (place.path.empty()) return ENOENT;
  if (place.path.back() == '/') return EISDIR;
  if (place.error != 0) return place.error;
  if (place.exists) {
    if (S_ISDIR(place.status.st_mode)) return EISDIR;
    if (const int error = errorOfAccess(place.path, W_OK)) return error;
  }
  if (place.isInPlace) return place.exists ? 0 : ENOENT;
  return errorOfAccess(openFolderOf(place.path), W_OK | X_OK);
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
  if (place.descriptor >= 0) return fcntl(place.descriptor, F_DUPFD_CLOEXEC, 0);
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
  const int descriptor = open(openFolderOf(path).c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return errno == EACCES;
  const bool isFlushed = flush(descriptor);
  const int error = errno;
  close(descriptor);
  errno = error;
  return isFlushed;
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
  if (place.isInPlace) {
    descriptor_ = openInPlace(place);
    if (descriptor_ < 0) fail(errno);
    return;
  }
  target_ = place.path;
  errno = EEXIST;
  for (int attempt = 1; descriptor_ < 0 && errno == EEXIST && attempt <= kMostAttempts; ++attempt) {
    temporary_ = temporaryName(target_, attempt);
    // 0600 until the old file's permissions are copied: it may be a private one.
    createTemporary(place.exists ? 0600 : 0666);
  }
  if (descriptor_ < 0) fail(errno);
  if (!place.exists) return;
  // The owner first: a change of owner clears bits. Only root may, so a failure is no error.
  const bool isOwned = fchown(descriptor_, place.status.st_uid, place.status.st_gid) == 0;
  if (fchmod(descriptor_, place.status.st_mode & (isOwned ? 07777 : 0777)) == 0) return;
  const int error = errno;
  removeTemporary();
  fail(error);
}

OutputFile::~OutputFile() { removeTemporary(); }

void OutputFile::removeTemporary() {
  if (descriptor_ >= 0) close(descriptor_);
  descriptor_ = -1;
  if (slot_ < 0) return;
  unlink(temporary_.c_str());
  forgetTemporary();
}

void OutputFile::write(const void* data, std::size_t size) {
  const char* next = static_cast<const char*>(data);
  for (const char* const end = next + size; next < end;) {
    const ssize_t written =
        ::write(descriptor_, next, std::min<std::size_t>(size_t(end - next), SSIZE_MAX));
    if (written == 0) fail(EIO);
    if (written < 0 && !waitAndRetry(descriptor_)) fail(errno);
    if (written > 0) next += written;
  }
  size_ += size;
}

void OutputFile::commit() {
  if (!flush(descriptor_)) fail(errno);
  const bool isTemporary = slot_ >= 0;
  struct stat status = {};
  if (isTemporary && fstat(descriptor_, &status) != 0) fail(errno);
  if (isTemporary && static_cast<std::size_t>(status.st_size) != size_) fail(EIO);
  const int closing = descriptor_;
  descriptor_ = -1;
  // After EINTR the descriptor is closed all the same on Linux, and the bytes are flushed.
  if (close(closing) != 0 && errno != EINTR) fail(errno);
  if (!isTemporary) return;
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
  forgetTemporary();
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
