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
#include <utility>

#include "system/files.h"

namespace {

namespace fs = std::filesystem;

constexpr int kMostLinks = 40;             // as Linux itself counts before it says ELOOP
constexpr int kMostAttempts = 100;         // to find a temporary name that is free
constexpr std::size_t kLongestName = 255;  // of one part of a path, on every common file system

/// In which the file stands, also where the path does not name it.
fs::path folderOf(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// What a path stands for, once its links are followed.
struct Place {
  fs::path path;        // without links in its last part
  int descriptor = -1;  // of this process, where the path stands for one
  bool isInPlace = false;
  bool exists = false;
  int error = 0;  // errno of why nobody can say what it stands for
  struct stat status = {};
};

/// True for /dev/fd, /proc/self/fd and the like: the descriptors of this very process.
bool holdsOwnDescriptors(const fs::path& folder) {
  const std::string own = "/proc/" + std::to_string(getpid()) + "/";
  return folder == "/dev/fd" || (folder.string().rfind(own, 0) == 0 && folder.filename() == "fd");
}

bool isNumber(const std::string& name) {
  return !name.empty() && name.size() <= 9 &&
         name.find_first_not_of("0123456789") == std::string::npos;
}

/// Follows the links of the last part by hand, because the file at their end may not exist yet.
/// Stops at /proc, whose links name things that may have no path: a pipe, a deleted file.
Place followLinks(const std::string& given) {
  Place place;
  place.path = given == "-" ? "/dev/fd/" + std::to_string(STDOUT_FILENO) : given;
  for (int links = 0; links <= kMostLinks; ++links) {
    std::error_code ignored;
    const fs::path folder = fs::canonical(folderOf(place.path), ignored);
    const std::string name = place.path.filename().string();
    if (given == "-" || (isNumber(name) && holdsOwnDescriptors(folder))) {
      place.isInPlace = true;
      place.descriptor = std::stoi(name);
      return place;
    }
    const bool isInProc = folder == "/proc" || folder.string().rfind("/proc/", 0) == 0;
    const fs::path linked = isInProc ? fs::path() : fs::read_symlink(place.path, ignored);
    if (!linked.empty()) {
      place.path = folderOf(place.path) / linked;  // which is `linked` alone where that has a root
      continue;
    }
    place.exists = stat(place.path.c_str(), &place.status) == 0;
    if (!place.exists && errno != ENOENT) place.error = errno;
    place.isInPlace = isInProc || (place.exists && !S_ISREG(place.status.st_mode));
    return place;
  }
  place.error = ELOOP;
  return place;
}

bool isAllowed(const fs::path& path, int mode) {
  return faccessat(AT_FDCWD, path.c_str(), mode, AT_EACCESS) == 0;
}

/// Where an output goes. Throws OutputError where something keeps the process from writing there.
Place findPlace(const std::string& given) {
  Place place = followLinks(given);
  const auto demand = [&given](bool claim, int otherwise = 0) {  // 0: errno says why
    if (!claim) throw OutputError(given, std::strerror(otherwise != 0 ? otherwise : errno));
  };
  if (place.descriptor >= 0) {
    const int flags = fcntl(place.descriptor, F_GETFL);
    demand(flags >= 0);
    demand((flags & O_ACCMODE) != O_RDONLY, EBADF);
    return place;
  }
  demand(!place.path.empty(), ENOENT);
  demand(place.path.has_filename(), EISDIR);
  demand(place.error == 0, place.error);
  demand(!S_ISDIR(place.status.st_mode), EISDIR);
  demand(!place.exists || isAllowed(place.path, W_OK));
  demand(place.exists || !place.isInPlace, ENOENT);
  demand(place.isInPlace || isAllowed(folderOf(place.path), W_OK | X_OK));
  return place;
}

/// NAME.tmp.PID, NAME cut where the whole would be too long for a file system; from the second
/// attempt on (a file of that name was left by a killed run of the same number) with a counter.
std::string temporaryName(const fs::path& target, int attempt) {
  std::string ending = ".tmp." + std::to_string(getpid());
  if (attempt > 1) ending += "." + std::to_string(attempt);
  const std::string name = target.filename().string().substr(0, kLongestName - ending.size());
  return folderOf(target) / (name + ending);
}

int openInPlace(const Place& place) {
  if (place.descriptor >= 0) return fcntl(place.descriptor, F_DUPFD_CLOEXEC, 0);
  return uninterrupted(
      [&place] { return open(place.path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY); });
}

/// Flushes to the disk. What cannot be flushed (a pipe, a device) is no error.
bool flush(int descriptor) {
  return uninterrupted([descriptor] { return fsync(descriptor); }) == 0 || errno == EINVAL ||
         errno == ENOTSUP || errno == EROFS;
}

/// Flushes the folder of a file, so that a rename in it outlives a power failure. A folder that may
/// be written but not read cannot be opened for that; the system flushes it in its own time.
bool flushFolderOf(const std::string& path) {
  const OpenFile folder(folderOf(path));
  return folder.isOpen() ? flush(folder.descriptor()) : errno == EACCES;
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
  // A device, a FIFO, a descriptor: there is no old content to keep.
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
  discard();
  fail(error);
}

OutputFile::~OutputFile() { discard(); }

void OutputFile::discard() {
  if (descriptor_ >= 0) close(descriptor_);
  descriptor_ = -1;
  if (isTemporary_) endTemporary(false);
}

void OutputFile::write(const void* data, std::size_t size) {
  // A call may write less than it is given: the rest is tried again, until an error says why.
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
  struct stat status = {};
  if (isTemporary_ && fstat(descriptor_, &status) != 0) fail(errno);
  if (isTemporary_ && static_cast<std::size_t>(status.st_size) != size_) fail(EIO);
  // After EINTR the descriptor is closed all the same on Linux, and the bytes are flushed.
  if (close(std::exchange(descriptor_, -1)) != 0 && errno != EINTR) fail(errno);
  if (!isTemporary_) return;
  if (!endTemporary(true) || !flushFolderOf(target_)) fail(errno);
}

void OutputFile::fail(int error) const { throw OutputError(path_, std::strerror(error)); }

void writeFile(const std::string& path, const void* data, std::size_t size) {
  OutputFile file(path);
  file.write(data, size);
  file.commit();
}

void checkOutput(const std::string& path) { findPlace(path); }

std::string outputTarget(const std::string& path) {
  std::error_code ignored;
  const fs::path linkless = fs::absolute(followLinks(path).path, ignored);
  const fs::path target = fs::weakly_canonical(linkless, ignored);
  return target.empty() ? linkless : target;
}
