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

/// What a run for this kind of picture alone, and all of it, would have been given.
Options wholeOf(const Options& options, Output::Kind kind) {
  Options whole = options;
  const bool isDepth = kind == Output::Kind::depth;
  whole.output = kind == Output::Kind::color ? "out" : "";
  whole.depthOutput = isDepth ? "out" : "";
  whole.normalsOutput = kind == Output::Kind::normals ? "out" : "";
  whole.depthMin = isDepth ? options.depthMin : 0;
  whole.depthMax = isDepth ? options.depthMax : 0;
  const auto isPlace = [](const GivenOption& given) {
    return given.name == "size" || given.name == "region" || given.name == "tile";
  };
  whole.given.erase(std::remove_if(whole.given.begin(), whole.given.end(), isPlace),
                    whole.given.end());
  return whole;
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

PartId partIdOf(Output::Kind kind, const Options& options, const Digest& scene,
                const std::vector<std::string>& meshFiles, int threads) {
  const Digest digest = pictureFingerprint(wholeOf(options, kind), scene, meshFiles, threads);
  return {nameOf(kind), options.width, options.height, hexadecimal(digest)};
}
