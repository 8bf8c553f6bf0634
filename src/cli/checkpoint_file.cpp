// CheckpointFile.
#include "cli/checkpoint_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "cli/options.h"
#include "image/output_file.h"

namespace {

constexpr std::size_t kTitleSize = 32, kDigestSize = sizeof(Digest);
constexpr std::size_t kHeaderSize = kTitleSize + 2 * kDigestSize;
constexpr char kTitle[kTitleSize] = "raytracer checkpoint 1\n";
constexpr char kMark[4] = {'T', 'i', 'l', 'e'};
constexpr std::size_t kHeadSize = sizeof kMark + 5 * 4;
/// So much damage in one place is looked through for whole records, no more.
constexpr std::int64_t kMostDamage = std::int64_t(64) << 20;

void appendNumber(unsigned number, Bytes& bytes) {
  for (int i = 0; i < 4; ++i) bytes.push_back(std::uint8_t(number >> (8 * i) & 255));
}

unsigned numberAt(const std::uint8_t* bytes) {
  return unsigned(bytes[0]) | unsigned(bytes[1]) << 8 | unsigned(bytes[2]) << 16 |
         unsigned(bytes[3]) << 24;
}

CheckpointFile::Tile tileAt(const std::uint8_t* head) {
  const auto number = [&](int i) { return numberAt(head + sizeof kMark + 4 * i); };
  return {{int(number(0)), int(number(1)), int(number(2)), int(number(3))}, number(4)};
}

}  // namespace

CheckpointFile::CheckpointFile(const std::string& path, const Digest& fingerprint)
    : path_(path), fingerprint_(fingerprint) {
  checkOutput(path);
  open();
  try {
    checkHeader();
  } catch (...) {
    close(descriptor_);
    throw;
  }
}

CheckpointFile::~CheckpointFile() { close(descriptor_); }

void CheckpointFile::fail(int error) const { throw OutputError(path_, std::strerror(error)); }

/// Another run may remove the file between our opening and locking it: then once more.
void CheckpointFile::open() {
  for (;;) {
    descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOCTTY | O_NONBLOCK, 0666);
    if (descriptor_ < 0) fail(errno);
    struct stat status = {};
    const bool isFile = fstat(descriptor_, &status) == 0 && S_ISREG(status.st_mode);
    const bool locked = isFile && lock();
    const bool isThere = locked && fstat(descriptor_, &status) == 0 && status.st_nlink > 0;
    if (isThere) return;
    close(descriptor_);
    if (!isFile) throw UsageError("-checkpoint: expected a plain file, found '" + path_ + "'");
    if (!locked) throw OutputError(path_, "another run keeps its checkpoint there");
  }
}

/// False where another run has the lock. A file system without locks is taken as it is.
bool CheckpointFile::lock() {
  while (flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
    if (errno == EWOULDBLOCK) return false;
    if (errno != EINTR) return true;
  }
  return true;
}

std::size_t CheckpointFile::readAt(Offset offset, std::uint8_t* bytes, std::size_t size) const {
  std::size_t done = 0;
  while (done < size) {
    const ssize_t count = pread(descriptor_, bytes + done, size - done, offset + Offset(done));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(errno);
    if (count == 0) break;
    done += std::size_t(count);
  }
  return done;
}

/// Title and fingerprint each suffice to know the file by, in case the other one is damaged.
void CheckpointFile::checkHeader() {
  std::error_code error;
  place_ = std::filesystem::canonical(path_, error).string();
  if (error) fail(error.value());
  std::uint8_t header[kHeaderSize] = {};
  const std::size_t size = readAt(0, header, sizeof header);
  const std::uint8_t* const fingerprint = header + kTitleSize;
  const bool titled = std::memcmp(header, kTitle, std::min(size, kTitleSize)) == 0;
  const bool isOurs = std::equal(fingerprint_.begin(), fingerprint_.end(), fingerprint);
  if (!titled && !isOurs) {
    throw UsageError("-checkpoint: expected a file that this program has made, found '" + path_ +
                     "', which is something else");
  }
  const Digest sum = sha256(header, kTitleSize + kDigestSize);
  const bool isRight = std::equal(sum.begin(), sum.end(), fingerprint + kDigestSize);
  if (isRight && !isOurs) {
    throw UsageError("-checkpoint: '" + path_ +
                     "' was made from another scene, other meshes or other arguments; expected "
                     "the command that made it, or no such file");
  }
  damaged_ = size == kHeaderSize && !isRight;
  if (!isRight || !titled) writeHeader();
  end_ = Offset(kHeaderSize);
}

/// On the disk before anything else, so that a power failure leaves a file that is known.
void CheckpointFile::writeHeader() {
  Bytes header(kTitle, kTitle + kTitleSize);
  header.insert(header.end(), fingerprint_.begin(), fingerprint_.end());
  const Digest sum = sha256(header.data(), header.size());
  header.insert(header.end(), sum.begin(), sum.end());
  append(header);
  if (fsync(descriptor_) != 0 && errno != EINVAL) fail(errno);
}

Digest CheckpointFile::checksumOf(const std::uint8_t* record, std::size_t size) const {
  Sha256 hash;
  hash.add(fingerprint_);
  hash.add(record, size);
  return hash.finish();
}

Bytes CheckpointFile::beginRecord(const Tile& tile) {
  Bytes record(kMark, kMark + sizeof kMark);
  for (const int side : {tile.area.left, tile.area.bottom, tile.area.right, tile.area.top}) {
    appendNumber(unsigned(side), record);
  }
  appendNumber(tile.pictures, record);
  return record;
}

void CheckpointFile::endRecord(Bytes& record) const {
  const Digest sum = checksumOf(record.data(), record.size());
  record.insert(record.end(), sum.begin(), sum.end());
}

/// The size of the whole record that begins `at`; 0 where there is none.
std::size_t CheckpointFile::readRecord(Offset at, const SizeOf& sizeOf, Bytes& record) {
  std::uint8_t head[kHeadSize];
  record.clear();
  if (readAt(at, head, kHeadSize) < kHeadSize) return 0;
  if (std::memcmp(head, kMark, sizeof kMark) != 0) return 0;
  const std::size_t pixels = sizeOf(tileAt(head));
  if (pixels == 0) return 0;
  const std::size_t size = kHeadSize + pixels;
  record.resize(size + kDigestSize);
  if (readAt(at, record.data(), record.size()) < record.size()) return 0;
  const Digest sum = checksumOf(record.data(), size);
  return std::equal(sum.begin(), sum.end(), record.data() + size) ? record.size() : 0;
}

/// Where a record may begin in [from, to); -1 where none does.
CheckpointFile::Offset CheckpointFile::findRecord(Offset from, Offset to) const {
  Bytes piece(65536);
  while (from < to) {
    const std::size_t size = readAt(from, piece.data(), piece.size());
    if (size < sizeof kMark) return -1;
    const auto end = piece.begin() + std::ptrdiff_t(size);
    const auto found = std::search(piece.begin(), end, std::begin(kMark), std::end(kMark));
    if (found != end) return from + (found - piece.begin());
    from += Offset(size - sizeof kMark + 1);
  }
  return -1;
}

void CheckpointFile::readTiles(const SizeOf& sizeOf, const Receiver& receive) {
  Bytes record;
  Offset at = end_;
  std::int64_t inVain = 0;  // bytes of what looked like records
  while (at >= 0 && inVain < kMostDamage) {
    if (const std::size_t size = readRecord(at, sizeOf, record)) {
      receive(tileAt(record.data()), record.data() + kHeadSize);
      damaged_ = damaged_ || at > end_;
      at += Offset(size);
      end_ = at;
      continue;
    }
    inVain += std::int64_t(record.size());
    at = findRecord(at + 1, end_ + kMostDamage);
  }
  if (ftruncate(descriptor_, end_) != 0) fail(errno);
}

void CheckpointFile::append(const Bytes& records) {
  std::size_t done = 0;
  while (done < records.size()) {
    const ssize_t count =
        pwrite(descriptor_, records.data() + done, records.size() - done, end_ + Offset(done));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) fail(count < 0 ? errno : EIO);
    done += std::size_t(count);
  }
  end_ += Offset(done);
}

void CheckpointFile::remove() {
  if (unlink(place_.c_str()) != 0 && errno != ENOENT) fail(errno);
}
