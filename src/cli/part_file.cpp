// The fingerprint of a picture is one SHA-256 over all that decides on its pixels, one after the
// other: version, scene, the files it reads, kinds of pictures, arguments. Texts go in with their
// lengths before them, numbers as 8 bytes, so that no two lists of them give the same bytes ("ab"
// "c" and "a" "bc"). Arguments count as they were given, word by word: that is stricter than need
// be, but a new argument cannot be forgotten. Parts in users' folders bear this fingerprint: its
// order stays as it is.
#include "cli/part_file.h"

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <cstring>
#include <map>
#include <stdexcept>

#include "cli/arguments.h"
#include "math/number.h"
#include "scene/wording.h"
#include "system/files.h"
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

/// In the order in which they were given: of two filters or patterns the last one holds. A grid
/// changes pixels only where its cells are drawn.
void addArguments(const std::vector<GivenArgument>& arguments, Sha256& hash) {
  const bool drawsCells =
      std::any_of(arguments.begin(), arguments.end(), [](const GivenArgument& given) {
        return given.name == "visualize_grid" || given.name == "visualize_grid_count";
      });
  for (const GivenArgument& given : arguments) {
    if (!actionOf(given.name).changesPixels || (given.name == "grid" && !drawsCells)) continue;
    addText(given.name, hash);
    hash.addNumber(given.words.size());
    for (const std::string& word : given.words) addText(word, hash);
  }
}

/// Two digits for each byte, the high one first.
std::string hexadecimal(const Digest& digest) {
  static constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  for (const std::uint8_t byte : digest) text += {kDigits[byte >> 4], kDigits[byte & 15]};
  return text;
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

Digest pictureFingerprint(const RenderRequest& render, const Digest& scene,
                          const std::vector<std::string>& inputFiles, int threads) {
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
  addPictures(render.results, hash);
  addArguments(render.given, hash);
  return hash.finish();
}

std::string textOf(const PartId& id) {
  return joined("raytracer part 1 ", id.kind, ' ', id.width, ' ', id.height, ' ', id.fingerprint);
}

TgaPart tgaPartOf(const OutputRequest& output, const RenderRequest& render, const Digest& scene,
                  const std::vector<std::string>& inputFiles, int threads) {
  static constexpr const char* kKinds[] = {"color", "depth", "normals"};
  static constexpr std::string_view kPlaces[] = {"size", "region", "tile"};
  assert(output.kind <= Kind::normals);
  // As if the run had been for this output alone, and wherever its part lies.
  RenderRequest alone = render;
  alone.results.outputs = {output};
  const auto isPlace = [](const GivenArgument& given) { return isOneOf(given.name, kPlaces); };
  alone.given.erase(std::remove_if(alone.given.begin(), alone.given.end(), isPlace),
                    alone.given.end());
  const Digest digest = pictureFingerprint(alone, scene, inputFiles, threads);
  const PictureRequest& picture = render.picture;
  const PartId id = {kKinds[int(output.kind)], picture.width, picture.height, hexadecimal(digest)};
  return {picture.area.left, picture.height - picture.area.top, textOf(id)};
}
