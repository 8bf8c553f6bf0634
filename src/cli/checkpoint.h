// Checkpoint: keeps finished tiles in a file, so that a run that was ended can be taken up.
#pragma once
#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

#include "image/bytes.h"
#include "render/renderer.h"
#include "system/files.h"
#include "system/sha256.h"

/// The file has a header, and finished tiles in any order, each with a checksum of its own, so that
/// a cut or damaged one costs itself and no other. Each tile is written as soon as it is finished:
/// whatever ends the program costs the tiles at hand.
class Checkpoint : public TileStore {
 public:
  /// Opens the file, or makes a new one, locks it against other runs, and sets in the pictures of
  /// `targets` (not owned) every tile that it holds whole. `picture` is their fingerprint. Throws
  /// OutputError where that cannot be done or another run has the file, UsageError where it is no
  /// checkpoint, or one of another picture; such a file stays as it is.
  Checkpoint(const std::string& path, const Digest& picture, const RenderTargets& targets);

  bool isFinished(const PixelRectangle& area) const override;
  /// Appends the tiles of `area` to the file. The first time that fails the user is warned; a tile
  /// that could not be kept is one that the next run renders again.
  void finish(const PixelRectangle& area) override;

  /// How much of the pictures was found in the file, from 0 to 1.
  double foundShare() const;
  /// True when the header or something before the last whole tile was damaged; a torn last one is
  /// no damage: so may end a run that is killed. (Public for its test.)
  bool wasDamaged() const { return damaged_; }
  /// Tells the user what was found in the file; nothing where it is new.
  void tell() const;

  /// The pictures are written: removes the file. Complains where that fails.
  void remove();

 private:
  void checkHeader();
  void readTiles();
  std::size_t readAt(off_t offset, Bytes& target) const;
  std::size_t takeRecord(const Bytes& bytes, std::size_t size);
  Bytes recordOf(std::uint32_t tile) const;
  Digest checksumOf(const std::uint8_t* record, std::size_t size) const;
  void write(const Bytes& bytes);
  [[noreturn]] void fail(int error) const;

  const std::string path_;
  const Digest fingerprint_;
  const RenderTargets targets_;
  const Tiling tiling_;
  std::vector<bool> found_;  // the tiles that the file held
  const OpenFile file_;
  std::string place_;  // the path with its links followed
  bool damaged_ = false;
  std::mutex mutex_;
  off_t end_ = 0;            // behind the last whole record; guarded by mutex_
  bool complained_ = false;  // likewise
};
