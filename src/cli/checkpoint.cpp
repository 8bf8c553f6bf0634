// Checkpoint.
#include "cli/checkpoint.h"

#include <exception>

#include "cli/fingerprint.h"
#include "cli/messages.h"
#include "render/tile_bytes.h"

namespace {

constexpr std::size_t kPiece = std::size_t(1) << 18;  // bytes that are written at once

/// The pixels of the pictures; none where there are none.
PixelRectangle wholeOf(const RenderTargets& targets) {
  const Image* image = targets.color     ? targets.color
                       : targets.depth   ? targets.depth
                       : targets.normals ? targets.normals
                       : targets.samples ? targets.samples
                                         : targets.materials;
  if (!image) return {0, 0, 0, 0};
  const int zoom = image == targets.samples ? targets.samplesZoom : 1;
  return {0, 0, image->Width() / zoom, image->Height() / zoom};
}

int blocksAlong(int pixels, int block) { return (pixels + block - 1) / block; }

}  // namespace

Checkpoint::Checkpoint(const std::string& path, const Digest& fingerprint,
                       const RenderTargets& targets)
    : targets_(targets),
      whole_(wholeOf(targets)),
      found_(std::size_t(blocksAlong(whole_.right, kBlock)) *
             std::size_t(blocksAlong(whole_.top, kBlock))),
      file_(path, fingerprint) {
  file_.readTiles(
      [this](const CheckpointFile::Tile& tile) { return bytesOf(tile); },
      [this](const CheckpointFile::Tile& tile, const std::uint8_t* pixels) { take(tile, pixels); });
  saving_ = std::make_unique<SavingThread>(
      [this](SavingThread::Clock::time_point deadline) { save(deadline); });
}

Checkpoint::~Checkpoint() = default;

/// 0 for a tile that no run of this picture can have made.
std::size_t Checkpoint::bytesOf(const CheckpointFile::Tile& tile) const {
  const auto isSpan = [](int from, int to, int end) {
    const bool begins = from >= 0 && from % kBlock == 0 && from < to;
    return begins && to <= end && (to % kBlock == 0 || to == end);
  };
  const bool fits = isSpan(tile.area.left, tile.area.right, whole_.right) &&
                    isSpan(tile.area.bottom, tile.area.top, whole_.top);
  const bool isKnown = tile.pictures != 0 && tile.pictures < 1u << kPictureKinds;
  if (!fits || !isKnown || (tile.pictures & ~pictureBits(targets_)) != 0) return 0;
  return tileByteCount(withPictures(targets_, tile.pictures), tile.area);
}

template <class Visit>
void Checkpoint::forEachBlock(const PixelRectangle& area, const Visit& visit) const {
  const auto columns = std::size_t(blocksAlong(whole_.right, kBlock));
  for (int j = area.bottom / kBlock; j < blocksAlong(area.top, kBlock); ++j) {
    for (int i = area.left / kBlock; i < blocksAlong(area.right, kBlock); ++i) {
      visit(std::size_t(j) * columns + std::size_t(i));
    }
  }
}

void Checkpoint::take(const CheckpointFile::Tile& tile, const std::uint8_t* pixels) {
  setTileBytes(withPictures(targets_, tile.pictures), tile.area, pixels);
  forEachBlock(tile.area, [&](std::size_t block) {
    found_[block] = std::uint8_t(found_[block] | tile.pictures);
  });
}

bool Checkpoint::isFinished(const RenderTargets& targets, const PixelRectangle& area) const {
  const unsigned wanted = pictureBits(targets);
  bool finished = true;
  forEachBlock(
      area, [&](std::size_t block) { finished = finished && (found_[block] & wanted) == wanted; });
  return finished;
}

void Checkpoint::finish(const RenderTargets& targets, const PixelRectangle& area) {
  const std::lock_guard<std::mutex> lock(mutex_);
  unsaved_.push_back({area, pictureBits(targets)});
}

double Checkpoint::foundPart() const {
  double wanted = 0, found = 0;
  for (unsigned bit = 1; bit < 1u << kPictureKinds; bit *= 2) {
    if (!(pictureBits(targets_) & bit)) continue;
    wanted += double(found_.size());
    for (const std::uint8_t block : found_) found += (block & bit) != 0 ? 1 : 0;
  }
  return found / wanted;
}

/// What cannot be saved now is tried again the next time: the pictures hold it meanwhile.
void Checkpoint::save(SavingThread::Clock::time_point deadline) {
  std::vector<CheckpointFile::Tile> tiles;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    tiles.swap(unsaved_);
  }
  try {
    saveAll(tiles, deadline);
  } catch (const std::exception& error) {
    if (!complained_) complain(std::string("warning: ") + error.what());
    complained_ = true;
  }
  if (tiles.empty()) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  unsaved_.insert(unsaved_.end(), tiles.begin(), tiles.end());
}

/// Takes out of `tiles` what is saved.
void Checkpoint::saveAll(std::vector<CheckpointFile::Tile>& tiles,
                         SavingThread::Clock::time_point deadline) {
  Bytes records;
  std::size_t left = tiles.size();
  while (left > 0 && SavingThread::Clock::now() < deadline) {
    const CheckpointFile::Tile& tile = tiles[--left];
    Bytes record = CheckpointFile::beginRecord(tile);
    appendTileBytes(withPictures(targets_, tile.pictures), tile.area, record);
    file_.endRecord(record);
    records.insert(records.end(), record.begin(), record.end());
    if (records.size() < kPiece && left > 0) continue;
    file_.append(records);
    records.clear();
    tiles.resize(left);
  }
  file_.append(records);
  tiles.resize(left);
}

void Checkpoint::stop() { saving_.reset(); }

void Checkpoint::remove() {
  stop();
  try {
    file_.remove();
  } catch (const std::exception& error) {
    complain(std::string("warning: ") + error.what());
  }
}

std::unique_ptr<Checkpoint> openCheckpoint(const Options& options, const Digest& scene,
                                           const std::vector<std::string>& meshFiles, int threads,
                                           const RenderTargets& targets) {
  if (options.checkpoint.empty()) return nullptr;
  Sha256 fingerprint;
  fingerprint.add(pictureFingerprint(options, scene, meshFiles, threads));
  fingerprint.addNumber(pictureBits(targets));  // tiles of floats are no tiles of bytes
  auto checkpoint = std::make_unique<Checkpoint>(options.checkpoint, fingerprint.finish(), targets);
  if (options.quiet) return checkpoint;
  if (checkpoint->wasDamaged()) {
    complain("warning: " + options.checkpoint + ": damaged; what it lost is rendered again");
  }
  const int percent = int(100 * checkpoint->foundPart());
  if (checkpoint->foundPart() > 0) {
    complain(options.checkpoint + ": taken up with " + std::to_string(percent) + " % done");
  }
  return checkpoint;
}
