// Checkpoint: keeps finished tiles in a file, so that a run that was ended can be taken up.
#pragma once
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "cli/checkpoint_file.h"
#include "cli/options.h"
#include "cli/saving_thread.h"
#include "render/renderer.h"

class Checkpoint : public TileKeeper {
 public:
  /// Opens the file, sets in `targets` (not owned) the tiles that it holds, and begins to save the
  /// others as they are finished. Throws as CheckpointFile does.
  Checkpoint(const std::string& path, const Digest& fingerprint, const RenderTargets& targets);
  ~Checkpoint() override;

  bool isFinished(const RenderTargets& targets, const PixelRectangle& area) const override;
  void finish(const RenderTargets& targets, const PixelRectangle& area) override;

  /// How much of the pictures was found in the file, from 0 to 1.
  double foundPart() const;
  bool wasDamaged() const { return file_.wasDamaged(); }

  /// Saves what is finished, and no more after. Complains where that fails.
  void stop();
  /// The pictures are written: removes the file. Complains where that fails.
  void remove();

 private:
  static constexpr int kBlock = 16;  // tiles begin and end at multiples, see TileKeeper
  std::size_t bytesOf(const CheckpointFile::Tile& tile) const;
  void take(const CheckpointFile::Tile& tile, const std::uint8_t* pixels);
  template <class Visit>
  void forEachBlock(const PixelRectangle& area, const Visit& visit) const;
  void save(SavingThread::Clock::time_point deadline);
  void saveAll(std::vector<CheckpointFile::Tile>& tiles, SavingThread::Clock::time_point deadline);

  const RenderTargets targets_;
  const PixelRectangle whole_;
  std::vector<std::uint8_t> found_;  // for each block, row by row: the pictures that hold it
  CheckpointFile file_;
  std::mutex mutex_;
  std::vector<CheckpointFile::Tile> unsaved_;  // guarded by mutex_
  bool complained_ = false;                    // of this thread alone that saves
  std::unique_ptr<SavingThread> saving_;       // last, so that it ends before all it uses
};

/// The checkpoint that `options` name, with a word to the user about what it holds; null where they
/// name none. `scene` is the digest of the scene's bytes; for the rest see pictureFingerprint.
std::unique_ptr<Checkpoint> openCheckpoint(const Options& options, const Digest& scene,
                                           const std::vector<std::string>& meshFiles, int threads,
                                           const RenderTargets& targets);
