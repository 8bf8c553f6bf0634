// CheckpointFile: written by appending whole records, read from the first to the last.
//
// Reading goes from record to record: the head of each says which tile it is and so how long it
// must be; if its checksum is right it is handed over, and the next one begins behind it. Where
// there is no whole record, the next mark "Tile" is looked for, byte by byte: bytes of pixels may
// look like one, but have no right checksum. The end of the last whole record is the end of the
// file from then on, so that a record torn by SIGKILL is overwritten by the next one.
#include "cli/checkpoint_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "cli/program.h"
#include "image/output_file.h"
#include "render/tile_bytes.h"

namespace {

constexpr std::size_t kTitleSize = 32, kDigestSize = sizeof(Digest);
constexpr std::size_t kHeaderSize = kTitleSize + 2 * kDigestSize;
constexpr char kTitle[kTitleSize] = "raytracer checkpoint 2\n";
constexpr char kMark[4] = {'T', 'i', 'l', 'e'};
constexpr std::size_t kHeadSize = sizeof kMark + 2 * 4;
/// So much damage in one place is looked through for whole records, no more.
constexpr off_t kMostDamage = off_t(64) << 20;

CheckpointFile::Tile tileOf(const std::uint8_t* record) {
  return {numberAt(record + sizeof kMark), numberAt(record + sizeof kMark + 4)};
}

void appendDigest(const Digest& digest, Bytes& bytes) {
  bytes.insert(bytes.end(), digest.begin(), digest.end());
}

bool begins(const std::uint8_t* bytes, const Digest& digest) {
  return std::equal(digest.begin(), digest.end(), bytes);
}

}  // namespace

CheckpointFile::CheckpointFile(const std::string& path, const Digest& fingerprint)
    : path_(path), fingerprint_(fingerprint) {
  checkOutput(path);
  open();
  checkHeader();
}

void CheckpointFile::fail(int error) const { throw OutputError(path_, std::strerror(error)); }

/// A plain file alone: a record is written at a place of its own, and the file is cut off. A FIFO
/// is opened without waiting (O_NONBLOCK), to be refused; a terminal does not become ours.
/// Another run may remove the file between our opening and locking it: then once more.
void CheckpointFile::open() {
  struct stat status = {};
  do {
    file_ = std::make_unique<OpenFile>(path_, O_RDWR | O_CREAT | O_NOCTTY | O_NONBLOCK);
    if (!file_->isOpen()) fail(errno);
    if (file_->regularSize() < 0) {
      throw UsageError("-checkpoint: expected a plain file, found '" + path_ + "'");
    }
    if (!file_->lock(false)) throw OutputError(path_, "another run keeps its checkpoint there");
  } while (fstat(file_->descriptor(), &status) != 0 || status.st_nlink == 0);
  std::error_code error;
  place_ = std::filesystem::canonical(path_, error).string();
  if (error) fail(error.value());
}

std::size_t CheckpointFile::readAt(off_t offset, std::uint8_t* target, std::size_t size) const {
  const ssize_t count = file_->readAt(offset, target, size);
  if (count < 0) fail(errno);
  return std::size_t(count);
}

/// Title and fingerprint each suffice to know the file by, in case the other one is damaged. A new
/// header is on the disk before anything else, so that a power failure leaves a file that is known.
void CheckpointFile::checkHeader() {
  // What a file that is shorter does not have stays 0: a run was killed while it made the file, or
  // somebody made an empty one for us.
  Bytes found(kHeaderSize);
  const std::size_t size = readAt(0, found.data(), kHeaderSize);
  const std::uint8_t* const fingerprint = found.data() + kTitleSize;
  const bool titled = std::memcmp(found.data(), kTitle, std::min(size, kTitleSize)) == 0;
  const bool isOurs = begins(fingerprint, fingerprint_);
  if (!titled && !isOurs) {
    throw UsageError("-checkpoint: expected a file that this program has made, found '" + path_ +
                     "', which is something else");
  }
  const Digest sum = sha256(found.data(), kTitleSize + kDigestSize);
  const bool isWhole = begins(fingerprint + kDigestSize, sum);
  if (isWhole && !isOurs) {
    throw UsageError("-checkpoint: '" + path_ +
                     "' was made from another scene, other meshes or other arguments; expected "
                     "the command that made it, or no such file");
  }
  end_ = off_t(kHeaderSize);
  if (isWhole) return;
  damaged_ = size == kHeaderSize;
  end_ = 0;
  Bytes header(kTitle, kTitle + kTitleSize);
  appendDigest(fingerprint_, header);
  appendDigest(sha256(header.data(), header.size()), header);
  appendBytes(header);
  if (fsync(file_->descriptor()) != 0 && errno != EINVAL) fail(errno);
}

/// The fingerprint is part of it: a record that was copied here from another picture's file is not
/// taken for one of ours.
Digest CheckpointFile::checksumOf(const std::uint8_t* record, std::size_t size) const {
  Sha256 hash;
  hash.add(fingerprint_);
  hash.add(record, size);
  return hash.finish();
}

/// True where a whole record begins `at`. In either case `record` has as many bytes as were read
/// for the checksum.
bool CheckpointFile::readRecord(off_t at, const SizeOf& sizeOf, Bytes& record) const {
  record.clear();
  std::uint8_t head[kHeadSize];
  if (readAt(at, head, kHeadSize) < kHeadSize) return false;
  if (std::memcmp(head, kMark, sizeof kMark) != 0) return false;
  const std::size_t pixels = sizeOf(tileOf(head));
  if (pixels == 0) return false;
  const std::size_t size = kHeadSize + pixels;
  record.resize(size + kDigestSize);
  if (readAt(at, record.data(), record.size()) < record.size()) return false;
  return begins(record.data() + size, checksumOf(record.data(), size));
}

/// Where a record may begin in [from, to); -1 where none does. The file is read in pieces that
/// overlap by so much that no mark is cut.
off_t CheckpointFile::findMark(off_t from, off_t to) const {
  Bytes piece(65536);
  while (from < to) {
    const std::size_t size = readAt(from, piece.data(), piece.size());
    if (size < sizeof kMark) return -1;
    const auto end = piece.begin() + std::ptrdiff_t(size);
    const auto found = std::search(piece.begin(), end, std::begin(kMark), std::end(kMark));
    if (found != end) return from + (found - piece.begin());
    from += off_t(size - sizeof kMark + 1);
  }
  return -1;
}

/// Each mark that begins no whole record may cost the reading and hashing of a tile: a file made of
/// nothing but marks would keep us busy for the square of its size, and is left at kMostDamage.
void CheckpointFile::readTiles(const SizeOf& sizeOf, const Receiver& receive) {
  Bytes record;
  off_t at = end_, inVain = 0;  // bytes of what looked like records
  while (at >= 0 && inVain < kMostDamage) {
    if (!readRecord(at, sizeOf, record)) {
      inVain += off_t(record.size());
      at = findMark(at + 1, end_ + kMostDamage);
      continue;
    }
    receive(tileOf(record.data()), record.data() + kHeadSize);
    damaged_ = damaged_ || at > end_;
    at += off_t(record.size());
    end_ = at;
  }
  if (ftruncate(file_->descriptor(), end_) != 0) fail(errno);
}

void CheckpointFile::append(const Tile& tile, const Bytes& pixels) {
  Bytes record(kMark, kMark + sizeof kMark);
  appendNumber(tile.number, record);
  appendNumber(tile.pictures, record);
  record.insert(record.end(), pixels.begin(), pixels.end());
  appendDigest(checksumOf(record.data(), record.size()), record);
  appendBytes(record);
}

/// At a place and not at the end: where the last try failed half way, as on a full disk, this one
/// writes over what it left. end_ moves only when all bytes are written.
void CheckpointFile::appendBytes(const Bytes& bytes) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t count =
        pwrite(file_->descriptor(), bytes.data() + done, bytes.size() - done, end_ + off_t(done));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) fail(count < 0 ? errno : EIO);
    done += std::size_t(count);
  }
  end_ += off_t(done);
}

/// The lock is still ours, so that no other run has begun to use the file.
void CheckpointFile::remove() {
  if (unlink(place_.c_str()) != 0 && errno != ENOENT) fail(errno);
}
