// The image ID of a part.
#include "cli/part_id.h"

#include <algorithm>
#include <cassert>
#include <sstream>

#include "cli/fingerprint.h"

namespace {

constexpr const char* kTitle = "raytracer part 1";

const char* nameOf(Output::Kind kind) {
  if (kind == Output::Kind::color) return "color";
  if (kind == Output::Kind::depth) return "depth";
  assert(kind == Output::Kind::normals);
  return "normals";
}

std::string hexadecimal(const Digest& digest) {
  std::string text;
  for (const std::uint8_t byte : digest) {
    text += "0123456789abcdef"[byte >> 4];
    text += "0123456789abcdef"[byte & 15];
  }
  return text;
}

/// The arguments but those that say which of all pixels are rendered.
std::vector<GivenArgument> withoutPlace(std::vector<GivenArgument> given) {
  const auto isPlace = [](const GivenArgument& argument) {
    return argument.name == "size" || argument.name == "region" || argument.name == "tile";
  };
  given.erase(std::remove_if(given.begin(), given.end(), isPlace), given.end());
  return given;
}

}  // namespace

std::string textOf(const PartId& id) {
  return std::string(kTitle) + " " + id.kind + " " + std::to_string(id.width) + " " +
         std::to_string(id.height) + " " + id.fingerprint;
}

bool readPartId(const std::string& text, PartId& id) {
  const std::size_t start = std::string(kTitle).size();
  if (text.compare(0, start, kTitle) != 0) return false;
  std::istringstream words(text.substr(start));
  PartId found;
  words >> found.kind >> found.width >> found.height >> found.fingerprint;
  if (words.fail() || textOf(found) != text) return false;
  const auto isSide = [](int side) { return side >= 1 && side <= kMaxImageSide; };
  if (!isSide(found.width) || !isSide(found.height)) return false;
  id = found;
  return true;
}

PartId partIdOf(const OutputRequest& output, const RenderRequest& render, const Digest& scene,
                const std::vector<std::string>& meshFiles, int threads) {
  const Digest digest =
      pictureFingerprint({output}, withoutPlace(render.given), scene, meshFiles, threads);
  return {nameOf(output.kind), render.picture.width, render.picture.height, hexadecimal(digest)};
}
