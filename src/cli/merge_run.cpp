// The run of `raytracer -merge`.
#include "cli/merge_run.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <memory>
#include <tuple>

#include "cli/part_cover.h"
#include "cli/program.h"
#include "image/output_file.h"
#include "image/picture_file.h"
#include "scene/input_error.h"
#include "system/files.h"
#include "system/worker_threads.h"

namespace {

constexpr std::size_t kMostComplaints = 20;
constexpr std::size_t kMostOpen = 256;  // files at a time

/// The rows of the whole picture, from the top one on, as BGR bytes. Keeps one.
class MergedRows {
 public:
  /// `parts` cover the picture and are in the order of their y; not owned.
  explicit MergedRows(const std::vector<PartFile>& parts)
      : parts_(parts), row_(3 * std::size_t(parts[0].id.width)) {}

  /// To be called for each y in turn, from 0 on. Throws InputError where a part cannot be read.
  const Bytes& row(int y) {
    const auto isOver = [y](const Active& part) { return part.of->y + part.of->height <= y; };
    active_.erase(std::remove_if(active_.begin(), active_.end(), isOver), active_.end());
    for (; next_ < parts_.size() && parts_[next_].y == y; ++next_) {
      const bool staysOpen = active_.size() < kMostOpen;
      active_.push_back({&parts_[next_], staysOpen ? open(parts_[next_]) : nullptr});
    }
    for (const Active& part : active_) {
      const std::unique_ptr<OpenFile> own = part.file ? nullptr : open(*part.of);
      const OpenFile& file = part.file ? *part.file : *own;
      part.of->readRow(file.descriptor(), y - part.of->y, &row_[3 * std::size_t(part.of->x)]);
    }
    return row_;
  }

 private:
  struct Active {
    const PartFile* of;
    std::unique_ptr<OpenFile> file;  // null: opened for each row
  };

  static std::unique_ptr<OpenFile> open(const PartFile& part) {
    auto file = std::make_unique<OpenFile>(part.path);
    if (file->isOpen()) return file;
    throw InputError(part.path, 0, std::string("cannot be read: ") + std::strerror(errno));
  }

  const std::vector<PartFile>& parts_;
  Bytes row_;
  std::size_t next_ = 0;
  std::vector<Active> active_;
};

void complainOf(const std::vector<std::string>& mistakes) {
  const std::size_t shown = std::min(mistakes.size(), kMostComplaints);
  for (std::size_t i = 0; i < shown; ++i) complain(mistakes[i]);
  if (shown < mistakes.size()) {
    complain("and " + std::to_string(mistakes.size() - shown) + " more mistakes");
  }
}

/// Leaves the files that are no parts out, and says so in `mistakes`.
std::vector<PartFile> readParts(const std::vector<std::string>& paths,
                                std::vector<std::string>& mistakes) {
  std::vector<PartFile> parts;
  for (const std::string& path : paths) {
    try {
      parts.push_back(PartFile::read(path));
    } catch (const InputError& error) {
      mistakes.push_back(error.what());
    }
  }
  return parts;
}

std::string sizeText(const PartId& id) {
  return std::to_string(id.width) + " x " + std::to_string(id.height) + " pixels";
}

void checkSamePicture(const std::vector<PartFile>& parts, std::vector<std::string>& mistakes) {
  for (const PartFile& part : parts) {
    const PartId &expected = parts[0].id, &found = part.id;
    if (textOf(found) == textOf(expected)) continue;
    const std::string start =
        part.path + ": expected a part of the same picture as " + parts[0].path + ", found one of ";
    if (found.width != expected.width || found.height != expected.height) {
      mistakes.push_back(start + sizeText(found) + " instead of " + sizeText(expected));
    } else if (found.kind != expected.kind) {
      mistakes.push_back(start + "its " + found.kind + " instead of its " + expected.kind);
    } else {
      mistakes.push_back(start + "another scene, other meshes or other arguments");
    }
  }
}

void write(const std::vector<PartFile>& parts, const std::string& path) {
  const int width = parts[0].id.width, height = parts[0].id.height;
  MergedRows rows(parts);
  if (formatOf(path) == PictureFormat::tga) {
    return writeTgaRows(
        width, height, [&rows](int y) -> const Bytes& { return rows.row(y); }, path);
  }
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    const std::uint8_t* pixel = rows.row(y).data();
    for (int x = 0; x < width; ++x, pixel += 3) {
      image.setPixel(x, height - 1 - y, Rgb8{pixel[2], pixel[1], pixel[0]});
    }
  }
  writePicture(image, path, hardwareThreads());
}

}  // namespace

int runMerge(const MergeRequest& options) {
  checkOutput(options.output);
  std::vector<std::string> mistakes;
  std::vector<PartFile> parts = readParts(options.parts, mistakes);
  if (mistakes.empty()) checkSamePicture(parts, mistakes);
  if (mistakes.empty()) {
    std::sort(parts.begin(), parts.end(), [](const PartFile& a, const PartFile& b) {
      return std::tie(a.y, a.x, a.path) < std::tie(b.y, b.x, b.path);
    });
    mistakes = coverMistakes(parts, parts[0].id.width, parts[0].id.height);
  }
  if (mistakes.empty()) {
    write(parts, options.output);
    return kDone;
  }
  complainOf(mistakes);
  return kSceneAtFault;
}
