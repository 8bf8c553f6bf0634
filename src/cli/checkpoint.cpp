// Checkpoint: written by appending whole records, read from the first to the last.
//
// The file begins with a header of 96 bytes: 32 of a title, the fingerprint, the SHA-256 of both.
// Then come records: "Tile", the tile's number in 4 bytes; its pixels in all pictures; the SHA-256
// of the fingerprint and all that.
//
// A worker thread that has finished a tile appends it. The next run of the same command reads them
// all before it renders, and its workers pass over them. It goes from record to record: the head of
// each says which tile it is and so how long it must be; if its checksum is right its pixels are
// set, and the next one begins behind it. Where there is no whole record, the next mark "Tile" is
// looked for, byte by byte: bytes of pixels may look like one, but have no right checksum. The end
// of the last whole record is the end of the file from then on, so that a torn one is overwritten.
#include "cli/checkpoint.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include "cli/program.h"
#include "image/output_file.h"

namespace {

/// Of the file: a checkpoint of layout 2, which had other records, is no file of ours.
constexpr std::uint64_t kLayout = 3;
constexpr char kTitle[32] = "raytracer checkpoint 3\n";
constexpr char kMark[4] = {'T', 'i', 'l', 'e'};
constexpr std::size_t kHeadSize = sizeof kMark + sizeof(std::uint32_t);
/// So much damage is looked through for whole records, no more.
constexpr off_t kMostDamage = off_t(64) << 20;

/// Throws OutputError where no file can be made there.
const std::string& checked(const std::string& path) {
  checkOutput(path);
  return path;
}

/// Tiles of floats are no tiles of bytes: the pictures count too.
Digest fingerprintOf(const Digest& picture, const RenderTargets& targets) {
  Sha256 hash;
  hash.add(picture);
  hash.addNumber(targets.pictureBits());
  hash.addNumber(kLayout);
  return hash.finish();
}

template <class Values>
void append(const Values& values, Bytes& bytes) {
  bytes.insert(bytes.end(), std::begin(values), std::end(values));
}

Bytes headerOf(const Digest& fingerprint) {
  Bytes header(std::begin(kTitle), std::end(kTitle));
  append(fingerprint, header);
  append(sha256(header.data(), header.size()), header);
  return header;
}

}  // namespace

/// A plain file alone: a record is written at a place of its own, and the file is cut off. A FIFO
/// is opened without waiting (O_NONBLOCK), to be refused; a terminal does not become ours. Another
/// run may have removed the file between our opening and locking it: it has no name then.
Checkpoint::Checkpoint(const std::string& path, const Digest& picture, const RenderTargets& targets)
    : path_(checked(path)),
      fingerprint_(fingerprintOf(picture, targets)),
      targets_(targets),
      tiling_{targets.size().x(), targets.size().y(), kSide},
      found_(std::size_t(tiling_.count())),
      file_(path, O_RDWR | O_CREAT | O_NOCTTY | O_NONBLOCK) {
  if (!file_.isOpen()) fail(errno);
  refuseIf(file_.regularSize() < 0, "-checkpoint: expected a plain file, found '", path, "'");
  struct stat status = {};
  if (!file_.lock(false) || fstat(file_.descriptor(), &status) != 0 || status.st_nlink == 0) {
    throw OutputError(path, "another run keeps its checkpoint there");
  }
  place_ = std::filesystem::canonical(path).string();
  checkHeader();
  readTiles();
}

/// Of what was found at the start alone: what this run finishes itself it does not ask for again,
/// so that what threads read here never changes.
bool Checkpoint::isFinished(const PixelRectangle& area) const {
  const std::vector<int> tiles = tiling_.tilesIn(area);
  return std::all_of(tiles.begin(), tiles.end(),
                     [&](int tile) { return found_[std::size_t(tile)]; });
}

void Checkpoint::finish(const PixelRectangle& area) {
  for (const int tile : tiling_.tilesIn(area)) {
    const Bytes record = recordOf(std::uint32_t(tile));
    const std::lock_guard<std::mutex> lock(mutex_);
    try {
      write(record);
    } catch (const OutputError& error) {
      if (!std::exchange(complained_, true)) complain(std::string("warning: ") + error.what());
    }
  }
}

/// Each tile counts the same, whatever its size.
double Checkpoint::foundShare() const {
  return double(std::count(found_.begin(), found_.end(), true)) / double(found_.size());
}

void Checkpoint::tell() const {
  if (damaged_) complain("warning: " + path_ + ": damaged; what it lost is rendered again");
  const double found = foundShare();
  if (found == 0) return;
  complain(path_ + ": taken up with " + std::to_string(int(100 * found)) + " % done");
}

/// The lock is still ours, so that no other run has begun to use the file.
void Checkpoint::remove() {
  if (unlink(place_.c_str()) == 0 || errno == ENOENT) return;
  complain("warning: " + std::string(OutputError(path_, std::strerror(errno)).what()));
}

void Checkpoint::fail(int error) const { throw OutputError(path_, std::strerror(error)); }

/// Title and fingerprint each suffice to know the file by, in case the other one is damaged. A new
/// header is on the disk before anything else, so that a power failure leaves a file that is known.
void Checkpoint::checkHeader() {
  const Bytes header = headerOf(fingerprint_);
  // What a file that is shorter does not have stays 0: a run was killed while it made the file, or
  // somebody made an empty one for us.
  Bytes found(header.size());
  const std::size_t size = readAt(0, found);
  end_ = off_t(header.size());
  if (found == header) return;
  const auto isSame = [&](std::size_t from, std::size_t count) {
    return std::memcmp(&found[from], &header[from], count) == 0;
  };
  refuseIf(!isSame(0, std::min(size, sizeof kTitle)) && !isSame(sizeof kTitle, sizeof fingerprint_),
           "-checkpoint: expected a file that this program has made, found '", path_,
           "', which is something else");
  const std::size_t summed = sizeof kTitle + sizeof fingerprint_;
  const Digest sum = sha256(found.data(), summed);
  refuseIf(
      std::equal(sum.begin(), sum.end(), &found[summed]), "-checkpoint: '", path_,
      "' was made from another scene, other meshes, pictures or arguments; expected the command "
      "that made it, or no such file");
  damaged_ = size == header.size();
  end_ = 0;
  write(header);
  if (fsync(file_.descriptor()) != 0 && errno != EINVAL) fail(errno);
}

/// Fills `target`, or its beginning where the file ends; returns how many bytes there were.
std::size_t Checkpoint::readAt(off_t offset, Bytes& target) const {
  const ssize_t count = file_.readAt(offset, target.data(), target.size());
  if (count < 0) fail(errno);
  return std::size_t(count);
}

/// The fingerprint is part of it: a record that was copied here from another picture's file is not
/// taken for one of ours.
Digest Checkpoint::checksumOf(const std::uint8_t* record, std::size_t size) const {
  Sha256 hash;
  hash.add(fingerprint_);
  hash.add(record, size);
  return hash.finish();
}

/// Called while other threads write to other tiles: it reads no pixel of these.
Bytes Checkpoint::recordOf(std::uint32_t tile) const {
  Bytes record(kHeadSize);
  std::memcpy(record.data(), kMark, sizeof kMark);
  std::memcpy(&record[sizeof kMark], &tile, sizeof tile);
  for (const PixelBytes& row : targets_.rowsOf(tiling_.areaOf(int(tile)))) {
    record.insert(record.end(), row.bytes, row.bytes + row.size);
  }
  append(checksumOf(record.data(), record.size()), record);
  return record;
}

/// Sets the pixels of the tile whose whole record the first `size` bytes begin with, and returns
/// how many are that record's; 0 where there is none.
std::size_t Checkpoint::takeRecord(const Bytes& bytes, std::size_t size) {
  if (size < kHeadSize || std::memcmp(bytes.data(), kMark, sizeof kMark) != 0) return 0;
  std::uint32_t tile;
  std::memcpy(&tile, &bytes[sizeof kMark], sizeof tile);
  if (tile >= found_.size()) return 0;
  const std::vector<PixelBytes> rows = targets_.rowsOf(tiling_.areaOf(int(tile)));
  std::size_t summed = kHeadSize;
  for (const PixelBytes& row : rows) summed += row.size;
  if (size < summed + sizeof(Digest)) return 0;
  const Digest sum = checksumOf(bytes.data(), summed);
  if (!std::equal(sum.begin(), sum.end(), &bytes[summed])) return 0;
  const std::uint8_t* next = &bytes[kHeadSize];
  for (const PixelBytes& row : rows) {
    std::memcpy(row.bytes, next, row.size);
    next += row.size;
  }
  found_[tile] = true;
  return summed + sizeof(Digest);
}

/// In pieces that hold the longest record, which the first tile's is, and the mark behind it. Where
/// one begins with no whole record, the next one begins with the next mark, of which none is cut.
/// Each mark that begins no whole record may cost the reading and hashing of a tile: a file made of
/// nothing but marks would keep us busy for the square of its size, and is left at kMostDamage.
void Checkpoint::readTiles() {
  Bytes piece(recordOf(0).size() + sizeof kMark);
  off_t at = end_, inVain = 0;  // bytes read without finding a record
  while (inVain < kMostDamage) {
    const std::size_t size = readAt(at, piece);
    if (size == 0) break;
    if (const std::size_t whole = takeRecord(piece, size)) {
      damaged_ = damaged_ || at > end_;
      end_ = at += off_t(whole);
      continue;
    }
    const auto end = piece.begin() + std::ptrdiff_t(size);
    const auto mark = std::search(piece.begin() + 1, end, std::begin(kMark), std::end(kMark));
    at += std::min(mark - piece.begin(), std::ptrdiff_t(piece.size() - sizeof kMark + 1));
    inVain += off_t(size);
  }
  if (ftruncate(file_.descriptor(), end_) != 0) fail(errno);
}

/// At a place and not at the end: where the last try failed half way, as on a full disk, this one
/// writes over what it left. end_ moves only when all bytes are written.
void Checkpoint::write(const Bytes& bytes) {
  if (!file_.writeAt(end_, bytes.data(), bytes.size())) fail(errno);
  end_ += off_t(bytes.size());
}
