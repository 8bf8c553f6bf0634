// Checkpoint. A tile's way: a worker thread finishes it and notes its number; the saving thread
// takes all that are noted, copies their pixels out of the pictures and appends them to the file.
// The next run of the same command reads them all before it renders, and its workers pass over
// them.
//
// Signals reach the saving thread through a pipe: a signal handler may do little, but it may write
// a byte (see passSignalsTo). The thread sleeps on that pipe between two times of saving.
#include "cli/checkpoint.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <bitset>
#include <cerrno>
#include <exception>
#include <system_error>

#include "cli/program.h"
#include "image/output_file.h"
#include "render/tile_bytes.h"

namespace {

constexpr std::chrono::milliseconds kInterval{500};
/// The program is to end within 100 ms of a signal.
constexpr std::chrono::milliseconds kLastSave{50};

/// Of the file: a checkpoint of layout 1, which had other records, is no file of ours.
constexpr std::uint64_t kLayout = 2;

/// How many tiles so many pixels have along an axis.
std::uint32_t tilesAlong(int pixels) {
  return std::uint32_t((pixels + TileStore::kSide - 1) / TileStore::kSide);
}

}  // namespace

/// Tiles of the file go straight into the pictures. One tile may come in several records, each of
/// other pictures: colours with samples are rendered in one pass, depth and normals in another.
Checkpoint::Checkpoint(const std::string& path, const Digest& fingerprint,
                       const RenderTargets& targets)
    : targets_(targets),
      whole_(wholeArea(targets)),
      columns_(tilesAlong(whole_.right)),
      rows_(tilesAlong(whole_.top)),
      found_(std::size_t(columns_) * rows_),
      file_(path, fingerprint) {
  file_.readTiles([this](const Tile& tile) { return byteCountOf(tile); },
                  [this](const Tile& tile, const std::uint8_t* pixels) {
                    const RenderTargets kept = withPictures(targets_, tile.pictures);
                    setTileBytes(kept, areaOf(tile.number), pixels);
                    std::uint8_t& found = found_[tile.number];
                    found = std::uint8_t(found | tile.pictures);
                  });
  startSaving();
}

Checkpoint::~Checkpoint() { stop(); }

PixelRectangle Checkpoint::areaOf(std::uint32_t tile) const {
  const int left = int(tile % columns_) * kSide, bottom = int(tile / columns_) * kSide;
  return {left, bottom, std::min(left + kSide, whole_.right), std::min(bottom + kSide, whole_.top)};
}

/// 0 for a tile that no run of this picture can have made.
std::size_t Checkpoint::byteCountOf(const Tile& tile) const {
  if (tile.number >= found_.size() || (tile.pictures & ~pictureBits(targets_)) != 0) return 0;
  return tileByteCount(withPictures(targets_, tile.pictures), areaOf(tile.number));
}

/// Calls visit(number) for the tiles that make up `area`.
template <class Visit>
void Checkpoint::forEachTile(const PixelRectangle& area, const Visit& visit) const {
  for (std::uint32_t j = tilesAlong(area.bottom); j < tilesAlong(area.top); ++j) {
    for (std::uint32_t i = tilesAlong(area.left); i < tilesAlong(area.right); ++i) {
      visit(j * columns_ + i);
    }
  }
}

/// Of what was found at the start alone: what this run finishes itself it does not ask for again,
/// so that found_ never changes while threads read it.
bool Checkpoint::isFinished(const RenderTargets& targets, const PixelRectangle& area) const {
  const std::uint32_t wanted = pictureBits(targets);
  bool finished = true;
  forEachTile(area, [&](std::uint32_t tile) { finished &= (found_[tile] & wanted) == wanted; });
  return finished;
}

void Checkpoint::finish(const RenderTargets& targets, const PixelRectangle& area) {
  const std::uint32_t pictures = pictureBits(targets);
  const std::lock_guard<std::mutex> lock(mutex_);
  forEachTile(area, [&](std::uint32_t tile) { unsaved_.push_back({tile, pictures}); });
}

/// Each picture of each tile counts the same, whatever its size.
double Checkpoint::foundShare() const {
  const auto count = [](std::uint32_t pictures) {
    return double(std::bitset<kPictureKinds>(pictures).count());
  };
  double found = 0;
  for (const std::uint8_t pictures : found_) found += count(pictures);
  return found / (double(found_.size()) * count(pictureBits(targets_)));
}

/// The pipe does not block: a handler that met a full one would hang the program that it is to end.
void Checkpoint::startSaving() {
  if (pipe2(signals_, O_CLOEXEC | O_NONBLOCK) != 0) {
    throw std::system_error(errno, std::generic_category(), "cannot make a pipe");
  }
  try {
    saving_ = std::thread([this] { saveUntilStopped(); });
  } catch (...) {
    for (const int end : signals_) close(end);
    throw;
  }
  passSignalsTo(signals_[1]);
}

/// Woken by a signal's number, by 0 from stop(), or by nothing for kInterval; saves in each case.
void Checkpoint::saveUntilStopped() {
  for (;;) {
    struct pollfd event = {signals_[0], POLLIN, 0};
    poll(&event, 1, int(kInterval.count()));
    unsigned char signal = 0;
    const bool called = read(signals_[0], &signal, 1) == 1;
    save(called && signal != 0 ? Clock::now() + kLastSave : Clock::time_point::max());
    if (called && signal == 0) return;
    if (called) endOnSignal(signal);
  }
}

/// Starts on no tile after the deadline. What cannot be saved now is tried again the next time: the
/// pictures hold it meanwhile.
void Checkpoint::save(Clock::time_point deadline) {
  std::vector<Tile> tiles;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    tiles.swap(unsaved_);
  }
  try {
    // From the last one on, so that what is left to save stays at the front. A tile that fails is
    // still among them.
    for (; !tiles.empty() && Clock::now() < deadline; tiles.pop_back()) {
      const Tile& tile = tiles.back();
      file_.append(tile, tileBytes(withPictures(targets_, tile.pictures), areaOf(tile.number)));
    }
  } catch (const std::exception& error) {
    if (!complained_) complain(std::string("warning: ") + error.what());
    complained_ = true;
  }
  // Workers may have finished others meanwhile: the lock is not held while the disk is waited for.
  const std::lock_guard<std::mutex> lock(mutex_);
  unsaved_.insert(unsaved_.end(), tiles.begin(), tiles.end());
}

/// From then on signals end the program at once again.
void Checkpoint::stop() {
  if (!saving_.joinable()) return;
  passSignalsTo(-1);
  const unsigned char end = 0;
  // The pipe is not full: whoever sent so many signals would have been answered by the first one.
  while (write(signals_[1], &end, 1) < 0 && errno == EINTR) {
  }
  saving_.join();
  for (const int descriptor : signals_) close(descriptor);
}

void Checkpoint::remove() {
  stop();
  try {
    file_.remove();
  } catch (const std::exception& error) {
    complain(std::string("warning: ") + error.what());
  }
}

std::unique_ptr<Checkpoint> openCheckpoint(const std::string& path, const Digest& picture,
                                           const RenderTargets& targets, bool quiet) {
  Sha256 fingerprint;
  fingerprint.add(picture);
  fingerprint.addNumber(pictureBits(targets));  // tiles of floats are no tiles of bytes
  fingerprint.addNumber(kLayout);
  auto checkpoint = std::make_unique<Checkpoint>(path, fingerprint.finish(), targets);
  if (quiet) return checkpoint;
  if (checkpoint->wasDamaged()) {
    complain("warning: " + path + ": damaged; what it lost is rendered again");
  }
  const double found = checkpoint->foundShare();
  if (found > 0) {
    complain(path + ": taken up with " + std::to_string(int(100 * found)) + " % done");
  }
  return checkpoint;
}
