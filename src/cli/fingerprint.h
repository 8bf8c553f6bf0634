// The fingerprint of a picture: equal where two runs would give the same bytes. By it a part of a
// picture is known to belong to a run.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "cli/request.h"
#include "system/sha256.h"

/// The digest of the program's version, the scene's bytes (`scene` is their digest), all bytes of
/// `inputFiles` (in an order that the scene gives, which may name one twice), which pictures are
/// wanted, and every argument as it was given, but those that change no pixel (see changesPicture)
/// and the files' names. Two ways of saying the same (a default that is given, 5 and 5.0) are
/// different. Files are hashed on so many threads; one that cannot be read, or is no plain file
/// that could be read twice, throws std::runtime_error.
Digest pictureFingerprint(const ResultRequest& results, const std::vector<GivenArgument>& given,
                          const Digest& scene, const std::vector<std::string>& inputFiles,
                          int threads);

/// False for an argument (its name without dashes) that changes no pixel whatever its words are,
/// such as -threads, and for those that name files. An argument is taken to change pixels unless it
/// is listed.
bool changesPicture(const std::string& name);

/// The digest of a plain file's digests: those of its pieces of 1 MB in order, then its size.
/// Throws std::runtime_error.
Digest fileDigest(const std::string& path, int threads);
