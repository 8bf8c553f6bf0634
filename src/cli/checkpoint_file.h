// CheckpointFile: an append-only file of finished tiles, each with a checksum of its own.
//
// The file begins with a header of 96 bytes: 32 of a title, the picture's fingerprint, the SHA-256
// of both. Then come records in any order: "Tile", the tile's number and its pictures as numbers of
// 4 bytes, the lowest first; its pixels; the SHA-256 of the fingerprint and all that. A record is
// told by its checksum alone: what has no right one is passed over, up to the next "Tile" that
// begins one that has. So a cut or damaged record costs its own tile and no other.
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "image/bytes.h"
#include "system/files.h"
#include "system/sha256.h"

class CheckpointFile {
 public:
  /// What a record holds besides pixels; the meaning of both numbers is the user's.
  struct Tile {
    std::uint32_t number;
    std::uint32_t pictures;
  };

  /// Opens the file, or makes a new one, and locks it against other runs. Throws OutputError where
  /// that cannot be done or another run has it, UsageError where it is no checkpoint, or one of a
  /// picture of another fingerprint; such a file stays as it is.
  CheckpointFile(const std::string& path, const Digest& fingerprint);

  /// Tells how many bytes of pixels a tile has; 0 where there can be no such tile.
  using SizeOf = std::function<std::size_t(const Tile& tile)>;
  using Receiver = std::function<void(const Tile& tile, const std::uint8_t* pixels)>;
  /// Hands over every tile that is whole. What follows the last one is cut off. To be called once,
  /// before append. Throws OutputError where the file cannot be read.
  void readTiles(const SizeOf& sizeOf, const Receiver& receive);

  /// True when the header or something before the last whole record was damaged; a torn last record
  /// is none: so ends every run that is killed.
  bool wasDamaged() const { return damaged_; }

  /// Appends a record. Throws OutputError; the next record is then written where this one began.
  void append(const Tile& tile, const Bytes& pixels);

  /// Removes the file from its folder. Throws OutputError.
  void remove();

 private:
  void open();
  void checkHeader();
  std::size_t readAt(off_t offset, std::uint8_t* target, std::size_t size) const;
  bool readRecord(off_t at, const SizeOf& sizeOf, Bytes& record) const;
  off_t findMark(off_t from, off_t to) const;
  void appendBytes(const Bytes& bytes);
  Digest checksumOf(const std::uint8_t* record, std::size_t size) const;
  [[noreturn]] void fail(int error) const;

  const std::string path_;
  const Digest fingerprint_;
  std::unique_ptr<const OpenFile> file_;
  std::string place_;  // the path with its links followed
  off_t end_ = 0;      // behind the last whole record
  bool damaged_ = false;
};
