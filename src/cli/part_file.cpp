// The fingerprint of a picture is one SHA-256 over all that decides on its pixels, one after the
// other: version, scene, the files it reads, kinds of pictures, arguments. Texts go in with their
// lengths before them, numbers as 8 bytes, so that no two lists of them give the same bytes ("ab"
// "c" and "a" "bc"). Arguments count as they were given, word by word: that is stricter than need
// be, but a new argument cannot be forgotten. Parts in users' folders bear this fingerprint: its
// order stays as it is.
//
// The header of a part is that of our TGAs (see image/tga.cpp) but for the image ID and the origin.
// Byte 0 of the 18 is the length of the ID, 2 the type (2: colours as they are), 8 to 15 are X, Y,
// width and height, the low byte first, 16 the bits of a pixel, 17 the descriptor (0x20: top row
// first). Then come the ID and the rows, BGR. Whatever has another header, ID or length is no part,
// or a damaged one: each check has its own message, from "no such thing" to "cut off", so that a
// user with hundreds of files sees at once what happened to one.
#include "cli/part_file.h"

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <cstring>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>

#include "cli/arguments.h"
#include "math/number.h"
#include "scene/input_error.h"
#include "system/worker_threads.h"

namespace {

using Kind = OutputRequest::Kind;

constexpr std::size_t kPiece = std::size_t(1) << 20;
constexpr std::size_t kStack = 1 << 18;

[[noreturn]] void failFile(const std::string& path, const std::string& reason) {
  throw std::runtime_error(path + ": cannot be read for the fingerprint: " + reason);
}

void addText(std::string_view text, Sha256& hash) {
  hash.addNumber(text.size());
  hash.add(text);
}

/// What of the arguments that name files changes pixels.
void addPictures(const ResultRequest& results, Sha256& hash) {
  const OutputRequest* const depth = results.find(Kind::depth);
  const OutputRequest* const samples = results.find(Kind::samples);
  hash.addNumber(results.find(Kind::color) != nullptr);
  hash.addNumber(depth != nullptr);
  hash.addNumber(bitsOf(depth ? depth->depthMin : 0));
  hash.addNumber(bitsOf(depth ? depth->depthMax : 0));
  hash.addNumber(results.find(Kind::normals) != nullptr);
  hash.addNumber(samples != nullptr);
  hash.addNumber(std::uint64_t(samples ? samples->zoom : 1));
  if (results.find(Kind::materials)) addText("materials", hash);
}

/// In the order in which they were given: of two filters or patterns the last one holds.
void addArguments(const std::vector<GivenArgument>& arguments, Sha256& hash) {
  for (const GivenArgument& given : arguments) {
    if (!findArgument(given.name)->action->changesPixels) continue;
    addText(given.name, hash);
    hash.addNumber(given.words.size());
    for (const std::string& word : given.words) addText(word, hash);
  }
}

}  // namespace

/// In pieces, because SHA-256 itself goes from block to block and cannot be shared among threads.
/// No more than one piece a thread is in memory.
Digest fileDigest(const std::string& path, int threads) {
  const OpenFile file(path);
  if (!file.isOpen()) failFile(path, std::strerror(errno));
  const off_t length = file.regularSize();  // asked for once: it may change
  if (length < 0) failFile(path, "expected a plain file, which can be read twice");
  const auto size = std::size_t(length);
  const std::size_t count = (size + kPiece - 1) / kPiece;
  std::vector<Digest> pieces(count);
  shareOnThreads(threads, kStack, count, [&](std::size_t i) {
    Bytes bytes(std::min(kPiece, size - i * kPiece));
    const ssize_t read = file.readAt(off_t(i * kPiece), bytes.data(), bytes.size());
    if (read < 0) failFile(path, std::strerror(errno));
    if (std::size_t(read) < bytes.size()) failFile(path, "it has become shorter");
    pieces[i] = sha256(bytes.data(), bytes.size());
  });
  Sha256 hash;
  for (const Digest& piece : pieces) hash.add(piece);
  hash.addNumber(size);
  return hash.finish();
}

Digest pictureFingerprint(const ResultRequest& results, const std::vector<GivenArgument>& given,
                          const Digest& scene, const std::vector<std::string>& inputFiles,
                          int threads) {
  Sha256 hash;
  addText(versionText(), hash);
  hash.add(scene);
  hash.addNumber(inputFiles.size());
  std::map<std::string, Digest> known;  // a file that is named a thousand times is read once
  for (const std::string& file : inputFiles) {
    const auto [found, isNew] = known.try_emplace(file);
    if (isNew) found->second = fileDigest(file, threads);
    hash.add(found->second);
  }
  addPictures(results, hash);
  addArguments(given, hash);
  return hash.finish();
}

namespace {

constexpr const char* kPartTitle = "raytracer part 1";
constexpr std::size_t kHeader = 18, kMostId = 255;

/// Two digits for each byte, the high one first.
std::string hexadecimal(const Digest& digest) {
  static constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  for (const std::uint8_t byte : digest) text += {kDigits[byte >> 4], kDigits[byte & 15]};
  return text;
}

/// The words are read back and written anew: so every other spelling (blanks, leading zeros, a
/// sign) is refused without a rule for each. True where `text` is what textOf gives for some `id`,
/// which is then set.
bool readId(const std::string& text, PartId& id) {
  std::istringstream words(text);
  std::string word;
  words >> word >> word >> word >> id.kind >> id.width >> id.height >> id.fingerprint;
  const auto isSide = [](int side) { return side >= 1 && side <= kMaxImageSide; };
  return !words.fail() && textOf(id) == text && isSide(id.width) && isSide(id.height);
}

[[noreturn]] void failPart(const std::string& path, const std::string& message) {
  throw InputError(path, 0, message);
}

[[noreturn]] void failNoPart(const std::string& path, const std::string& found) {
  failPart(path, "expected a TGA that -region or -tile has written, found " + found);
}

/// Fewer bytes than `size` only at the end of the file. Throws InputError.
std::size_t readAt(const std::string& path, const OpenFile& file, std::int64_t offset,
                   std::uint8_t* target, std::size_t size) {
  const ssize_t count = file.readAt(off_t(offset), target, size);
  if (count < 0) failPart(path, std::string("cannot be read: ") + std::strerror(errno));
  return std::size_t(count);
}

/// Apart from sizes and places, the header that a part has.
bool isHeader(const std::uint8_t* header) {
  const auto isZero = [](std::uint8_t byte) { return byte == 0; };
  return header[1] == 0 && header[2] == 2 && std::all_of(header + 3, header + 8, isZero) &&
         header[16] == 24 && header[17] == 0x20;
}

std::string bytesText(std::int64_t count) { return std::to_string(count) + " bytes"; }

/// Where the top row begins, in bytes.
std::int64_t pixelsStart(const PartFile& part) {
  return std::int64_t(kHeader + textOf(part.id).size());
}

/// Throws InputError where the part reaches out of its picture, or the file of `found` bytes does
/// not end with its last pixel.
void checkPlaceAndSize(const PartFile& part, std::int64_t found) {
  const bool fits = part.width > 0 && part.height > 0 && part.right() <= part.id.width &&
                    part.bottom() <= part.id.height;
  if (!fits) failPart(part.path, "damaged: its place is not in the picture that it is a part of");
  const std::int64_t expected = pixelsStart(part) + 3 * std::int64_t(part.width) * part.height;
  if (found == expected) return;
  failPart(part.path, (found < expected ? "cut off: expected " : "expected ") +
                          bytesText(expected) + ", found " + bytesText(found));
}

}  // namespace

std::string textOf(const PartId& id) {
  return std::string(kPartTitle) + " " + id.kind + " " + std::to_string(id.width) + " " +
         std::to_string(id.height) + " " + id.fingerprint;
}

PartId partIdOf(const OutputRequest& output, const RenderRequest& render, const Digest& scene,
                const std::vector<std::string>& inputFiles, int threads) {
  static constexpr const char* kNames[] = {"color", "depth", "normals"};
  assert(output.kind <= OutputRequest::Kind::normals);
  std::vector<GivenArgument> given;
  const auto isNoPlace = [](const GivenArgument& argument) {
    return argument.name != "size" && argument.name != "region" && argument.name != "tile";
  };
  std::copy_if(render.given.begin(), render.given.end(), std::back_inserter(given), isNoPlace);
  // As if the run had been for this output alone.
  ResultRequest alone;
  alone.outputs = {output};
  const Digest digest = pictureFingerprint(alone, given, scene, inputFiles, threads);
  return {kNames[int(output.kind)], render.picture.width, render.picture.height,
          hexadecimal(digest)};
}

std::unique_ptr<const OpenFile> PartFile::open(const std::string& path) {
  auto file = std::make_unique<const OpenFile>(path);
  if (!file->isOpen()) failPart(path, std::string("cannot be read: ") + std::strerror(errno));
  return file;
}

PartFile PartFile::read(const std::string& path) {
  const std::unique_ptr<const OpenFile> file = open(path);
  std::uint8_t header[kHeader + kMostId] = {};
  const auto size = std::int64_t(file->regularSize());
  if (size < 0) failNoPart(path, "no plain file");
  const std::size_t found = readAt(path, *file, 0, header, sizeof header);
  if (found < kHeader) failNoPart(path, bytesText(size));
  if (!isHeader(header)) failNoPart(path, "another kind of file");
  if (header[0] == 0) failNoPart(path, "a TGA without an image ID, which is no part");
  if (found < kHeader + header[0]) failNoPart(path, bytesText(size));
  const auto field = [&header](int at) { return int(littleEndian16(header + at)); };
  PartFile part = {path, {}, field(8), field(10), field(12), field(14)};
  const std::string id(header + kHeader, header + kHeader + header[0]);
  if (!readId(id, part.id)) failNoPart(path, "a TGA with another image ID");
  checkPlaceAndSize(part, size);
  return part;
}

void PartFile::readRow(const OpenFile& file, int row, std::uint8_t* target) const {
  const std::size_t size = 3 * std::size_t(width);
  const std::int64_t offset = pixelsStart(*this) + std::int64_t(size) * row;
  if (readAt(path, file, offset, target, size) < size) failPart(path, "has become shorter");
}
