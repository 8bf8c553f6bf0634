// The image ID of a part: which picture it belongs to.
#pragma once
#include <string>
#include <vector>

#include "cli/outputs.h"
#include "system/sha256.h"

struct PartId {
  std::string kind;         ///< "color", "depth" or "normals"
  int width = 0;            ///< of the whole picture, in pixels
  int height = 0;           ///< likewise
  std::string fingerprint;  ///< in hexadecimal: equal for all parts of one picture alone
};

/// "raytracer part 1 KIND WIDTH HEIGHT FINGERPRINT", at most 110 bytes.
std::string textOf(const PartId& id);

/// True where `text` is what textOf gives for some `id`, which is then set.
bool readPartId(const std::string& text, PartId& id);

/// The ID of the parts of this output of the render. The fingerprint is pictureFingerprint's for
/// this kind of picture alone, and without -size, -region and -tile: so one run may give several
/// kinds, and another the same ones singly. It is of kind color, depth or normals; for the rest,
/// and errors, see pictureFingerprint.
PartId partIdOf(const OutputRequest& output, const RenderRequest& render, const Digest& scene,
                const std::vector<std::string>& meshFiles, int threads);
