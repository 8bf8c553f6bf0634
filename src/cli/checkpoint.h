// Checkpoint: keeps finished tiles in a file, so that a run that was ended can be taken up.
#pragma once
#include <chrono>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "cli/checkpoint_file.h"
#include "render/image_plane.h"
#include "render/renderer.h"

/// A tile is a square of TileStore::kSide pixels, or what of it lies in the picture; they are
/// numbered row by row from the lower left corner on. Saving goes on beside the rendering, on a
/// thread of its own: twice in a second, far below the 5 s of work that may be lost, so that little
/// has to be saved when a signal asks the program to end. Then what is finished is saved once more,
/// for 50 ms at most, and the program ends. Only one checkpoint may be there at a time.
class Checkpoint : public TileStore {
 public:
  /// Opens the file, sets in `targets` (not owned) the tiles that it holds, and begins to save the
  /// others as they are finished. Throws as CheckpointFile does, and std::system_error where there
  /// is no thread.
  Checkpoint(const std::string& path, const Digest& fingerprint, const RenderTargets& targets);
  ~Checkpoint() override;

  bool isFinished(const RenderTargets& targets, const PixelRectangle& area) const override;
  void finish(const RenderTargets& targets, const PixelRectangle& area) override;

  /// How much of the pictures was found in the file, from 0 to 1.
  double foundShare() const;
  bool wasDamaged() const { return file_.wasDamaged(); }

  /// Saves what is finished, and no more after. Complains where that fails.
  void stop();
  /// The pictures are written: removes the file. Complains where that fails.
  void remove();

 private:
  using Tile = CheckpointFile::Tile;
  using Clock = std::chrono::steady_clock;

  PixelRectangle areaOf(std::uint32_t tile) const;
  std::size_t byteCountOf(const Tile& tile) const;
  template <class Visit>
  void forEachTile(const PixelRectangle& area, const Visit& visit) const;
  void startSaving();
  void saveUntilStopped();
  void save(Clock::time_point deadline);

  const RenderTargets targets_;
  const PixelRectangle whole_;
  const std::uint32_t columns_, rows_;  // of tiles
  std::vector<std::uint8_t> found_;     // for each tile: the pictures whose pixels the file held
  CheckpointFile file_;
  std::mutex mutex_;
  std::vector<Tile> unsaved_;  // guarded by mutex_
  bool complained_ = false;    // of the saving thread alone
  int signals_[2] = {-1, -1};  // of a pipe: the numbers of signals, or 0 to come to an end
  std::thread saving_;
};

/// Opens the checkpoint at `path` and tells the user, unless `quiet`, what it holds. `picture` is
/// the fingerprint of the picture that `targets` are to have.
std::unique_ptr<Checkpoint> openCheckpoint(const std::string& path, const Digest& picture,
                                           const RenderTargets& targets, bool quiet);
