// A part of a picture, as -region and -tile write it: a TGA that any viewer shows, whose origin
// fields hold where it lies in the whole picture, and whose image ID says of which: by the
// fingerprint of a picture, which is equal where two runs would give the same bytes.
#pragma once
#include <string>
#include <vector>

#include "cli/request.h"
#include "image/picture_file.h"
#include "system/sha256.h"

/// The fingerprint of what `render` asks for: the digest of the program's version, the scene's
/// bytes (`scene` is their digest), all bytes of `inputFiles` (in an order that the scene gives,
/// which may name one twice), which pictures are wanted, and every argument as it was given but
/// those that change no pixel (ArgumentAction::changesPixels) and the files' names. Two ways of
/// saying the same (a default that is given, 5 and 5.0) are different. Files are hashed on so many
/// threads; one that cannot be read, or is no plain file that could be read twice, throws
/// std::runtime_error.
Digest pictureFingerprint(const RenderRequest& render, const Digest& scene,
                          const std::vector<std::string>& inputFiles, int threads);

/// The digest of a plain file's digests: those of its pieces of 1 MB in order, then its size.
/// Throws std::runtime_error. (Public for its test.)
Digest fileDigest(const std::string& path, int threads);

/// Which picture a part belongs to.
struct PartId {
  std::string kind;         ///< "color", "depth" or "normals"
  int width = 0;            ///< of the whole picture, in pixels
  int height = 0;           ///< likewise
  std::string fingerprint;  ///< in hexadecimal: equal for all parts of one picture alone
};

/// "raytracer part 1 KIND WIDTH HEIGHT FINGERPRINT", at most 110 bytes: the image ID.
std::string textOf(const PartId& id);

/// What marks this output of the render as a part: where it lies, and the ID. The fingerprint is
/// pictureFingerprint's for this kind of picture alone, and without -size, -region and -tile: so
/// one run may give several kinds, and another the same ones singly. It is of kind color, depth or
/// normals; for the rest, and errors, see pictureFingerprint.
TgaPart tgaPartOf(const OutputRequest& output, const RenderRequest& render, const Digest& scene,
                  const std::vector<std::string>& inputFiles, int threads);
