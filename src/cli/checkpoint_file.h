// CheckpointFile: finished tiles of a picture in a file, each with a checksum of its own.
//
// The file: a header of 96 bytes (32 of a title, the picture's fingerprint, the SHA-256 of both),
// then records in any order, to which new ones are appended: "Tile", then left, bottom, right, top
// and pictures (pictureBits) as 32-bit numbers, the lowest byte first; the pixels
// (appendTileBytes); the SHA-256 of the fingerprint and all that. What has no right checksum is
// passed over.
#pragma once
#include <functional>
#include <string>

#include "image/bytes.h"
#include "render/image_plane.h"
#include "system/sha256.h"

class CheckpointFile {
 public:
  /// What a record holds besides pixels.
  struct Tile {
    PixelRectangle area;
    unsigned pictures;
  };

  /// Opens the file, or makes a new one, and locks it against other runs. Throws OutputError where
  /// that cannot be done or another run has it, UsageError where it is no checkpoint, or one of a
  /// picture of another fingerprint; such a file stays as it is.
  CheckpointFile(const std::string& path, const Digest& fingerprint);
  ~CheckpointFile();
  CheckpointFile(const CheckpointFile&) = delete;
  CheckpointFile& operator=(const CheckpointFile&) = delete;

  /// Tells how many bytes of pixels a tile has; 0 where there can be no such tile.
  using SizeOf = std::function<std::size_t(const Tile& tile)>;
  using Receiver = std::function<void(const Tile& tile, const std::uint8_t* pixels)>;
  /// Hands over every tile that is whole. What follows the last one is cut off. To be called once,
  /// before append. Throws OutputError where the file cannot be read.
  void readTiles(const SizeOf& sizeOf, const Receiver& receive);

  /// True when what readTiles passed over was not a torn last record alone.
  bool wasDamaged() const { return damaged_; }

  /// The record of a tile, for append: its head, to which the pixels are appended ...
  static Bytes beginRecord(const Tile& tile);
  /// ... and then the checksum.
  void endRecord(Bytes& record) const;

  /// Appends whole records. Throws OutputError; the next ones are then written where these began.
  void append(const Bytes& records);

  /// Removes the file from its folder. Throws OutputError.
  void remove();

 private:
  using Offset = std::int64_t;
  void open();
  bool lock();
  void checkHeader();
  void writeHeader();
  std::size_t readAt(Offset offset, std::uint8_t* bytes, std::size_t size) const;
  std::size_t readRecord(Offset at, const SizeOf& sizeOf, Bytes& record);
  Offset findRecord(Offset from, Offset to) const;
  Digest checksumOf(const std::uint8_t* record, std::size_t size) const;
  [[noreturn]] void fail(int error) const;

  const std::string path_;
  std::string place_;  // the same, links followed
  const Digest fingerprint_;
  int descriptor_ = -1;
  Offset end_ = 0;  // behind the last whole record
  bool damaged_ = false;
};
