// Checkpoint: finished tiles come back with their bytes, or not at all.
#include "cli/checkpoint.h"

#include "check.h"
#include "cli/program.h"
#include "image/output_file.h"
#include "random.h"
#include "render/image_plane.h"
#include "run_program.h"

namespace {

using check::contentOf;

constexpr int kWidth = 40, kHeight = 25, kZoom = 2;  // 3 x 2 tiles of 16 pixels
constexpr std::size_t kHeader = 96, kHead = 8, kSum = 32;

Digest fingerprint(std::uint8_t value) {
  Digest digest;
  digest.fill(value);
  return digest;
}

/// Pictures of all kinds, black, or with a colour of its own in each place.
struct Pictures {
  Image color{kWidth, kHeight}, depth{kWidth, kHeight}, normals{kWidth, kHeight};
  Image samples{kWidth * kZoom, kHeight* kZoom};

  void paint() {
    Random random(5);
    for (Image* image : {&color, &depth, &normals, &samples}) {
      for (int y = 0; y < image->Height(); ++y) {
        for (int x = 0; x < image->Width(); ++x) {
          const auto any = [&] { return std::uint8_t(1 + random.index(255)); };
          image->setPixel(x, y, Rgb8{any(), any(), any()});
        }
      }
    }
  }
  RenderTargets targets() {
    RenderTargets all;
    all.color = &color;
    all.depth = &depth;
    all.normals = &normals;
    all.samples = &samples;
    all.samplesZoom = kZoom;
    return all;
  }
  RenderTargets colorAlone() {
    RenderTargets one;
    one.color = &color;
    return one;
  }
};

std::vector<PixelRectangle> tiles() {
  std::vector<PixelRectangle> all;
  for (int bottom : {0, 16}) {
    for (int left : {0, 16, 32}) {
      all.push_back({left, bottom, std::min(left + 16, kWidth), std::min(bottom + 16, kHeight)});
    }
  }
  return all;
}

/// Pixels of `image` in a tile, enlarged `zoom` times, that are those of `expected` and that are
/// black; a tile is `whole` or `missing`, or else something is wrong.
enum class Found { whole, missing, wrong };
Found compare(const Image& image, const Image& expected, const PixelRectangle& area, int zoom) {
  int same = 0, black = 0, count = 0;
  for (int y = area.bottom * zoom; y < area.top * zoom; ++y) {
    for (int x = area.left * zoom; x < area.right * zoom; ++x) {
      ++count;
      same += image.getPixel(x, y) == expected.getPixel(x, y);
      black += image.getPixel(x, y) == Rgb8{};
    }
  }
  return same == count ? Found::whole : black == count ? Found::missing : Found::wrong;
}

/// A file of all tiles of the colour picture, each a record of its own.
struct Kept : check::ScratchFolder {
  Kept() {
    painted.paint();
    Checkpoint checkpoint(name, fingerprint(1), painted.colorAlone());
    for (const PixelRectangle& tile : tiles()) checkpoint.finish(tile);
    bytes = contentOf(name);
  }

  const std::string name = file("c");
  Pictures painted;
  std::string bytes;
};

/// Takes up what the file `name` holds, and counts the tiles that are whole; -1 where a tile is
/// neither whole nor missing, or isFinished says the contrary.
int countWhole(Kept& kept, const std::string& name) {
  Pictures pictures;
  const Checkpoint checkpoint(name, fingerprint(1), pictures.colorAlone());
  int whole = 0;
  for (const PixelRectangle& tile : tiles()) {
    const Found found = compare(pictures.color, kept.painted.color, tile, 1);
    if (found == Found::wrong) return -1;
    if (checkpoint.isFinished(tile) != (found == Found::whole)) return -1;
    whole += found == Found::whole;
  }
  return whole;
}

}  // namespace

TEST("tiles come back in all pictures") {
  const check::ScratchFolder folder;
  Pictures painted, pictures;
  painted.paint();
  const std::vector<PixelRectangle> all = tiles();
  {
    Checkpoint checkpoint(folder.file("c"), fingerprint(1), painted.targets());
    CHECK_EQUAL(checkpoint.foundShare(), 0.0);
    checkpoint.finish(all[0]);
    checkpoint.finish({16, 0, 40, 25});     // four tiles at once
    CHECK(!checkpoint.isFinished(all[0]));  // it tells what it has found
  }
  const Checkpoint checkpoint(folder.file("c"), fingerprint(1), pictures.targets());
  CHECK(!checkpoint.wasDamaged());
  CHECK_NEAR(checkpoint.foundShare(), 5 / 6.0, 1e-12);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Found expected = i == 3 ? Found::missing : Found::whole;
    CHECK(compare(pictures.color, painted.color, all[i], 1) == expected);
    CHECK(compare(pictures.samples, painted.samples, all[i], kZoom) == expected);
    CHECK(compare(pictures.depth, painted.depth, all[i], 1) == expected);
    CHECK(compare(pictures.normals, painted.normals, all[i], 1) == expected);
    CHECK_EQUAL(checkpoint.isFinished(all[i]), i != 3);
  }
  CHECK(checkpoint.isFinished({16, 0, 40, 16}));
  CHECK(!checkpoint.isFinished({0, 0, 40, 25}));
}

TEST("a finished tile is saved at once, and so is the next one") {
  const check::ScratchFolder folder;
  Pictures painted;
  painted.paint();
  Checkpoint checkpoint(folder.file("c"), fingerprint(1), painted.targets());
  std::size_t size = kHeader;
  for (const PixelRectangle& tile : tiles()) {
    CHECK_EQUAL(contentOf(folder.file("c")).size(), size);
    checkpoint.finish(tile);
    size += kHead + 3 * (3 + kZoom * kZoom) * tile.pixelCount() + kSum;
  }
  CHECK_EQUAL(contentOf(folder.file("c")).size(), size);
}

TEST("a file that is cut off anywhere gives back all tiles before the cut") {
  Kept kept;
  CHECK_EQUAL(countWhole(kept, kept.name), 6);
  CHECK_EQUAL(contentOf(kept.name).size(), kept.bytes.size());  // nothing was lost on the way
  const std::string cut = kept.file("cut");
  for (std::size_t size = 0; size < kept.bytes.size(); size += size < 200 ? 1 : 13) {
    kept.write("cut", kept.bytes.substr(0, size));
    int expected = 0;
    for (std::size_t end = kHeader; expected < 6; ++expected) {
      const PixelRectangle tile = tiles()[std::size_t(expected)];
      end += kHead + 3 * tile.pixelCount() + kSum;
      if (end > size) break;
    }
    CHECK_EQUAL(countWhole(kept, cut), expected);
    CHECK_EQUAL(countWhole(kept, cut), expected);  // also of the file that is then left
  }
}

TEST("a byte that is changed anywhere loses one tile at most, and never gives wrong pixels") {
  Kept kept;
  for (std::size_t at = 0; at < kept.bytes.size(); at += at < 200 ? 1 : 7) {
    std::string bytes = kept.bytes;
    bytes[at] = char(bytes[at] ^ 0x10);
    kept.write("changed", bytes);
    CHECK_EQUAL(countWhole(kept, kept.file("changed")), at < kHeader ? 6 : 5);
  }
}

TEST("bytes put in, taken out, or doubled do no harm to other tiles") {
  Kept kept;
  Random random(6);
  for (int round = 0; round < 200; ++round) {
    std::string bytes = kept.bytes;
    const std::size_t at = kHeader + std::size_t(random.index(int(bytes.size() - kHeader)));
    const std::size_t count = 1 + std::size_t(random.index(100));
    if (round % 3 == 0) bytes.erase(at, count);
    if (round % 3 == 1) bytes.insert(at, bytes, kHeader, count);
    if (round % 3 == 2) bytes.insert(at, "TileTileTile");
    kept.write("changed", bytes);
    CHECK(countWhole(kept, kept.file("changed")) >= 4);
  }
}

TEST("records that lie are passed over: tiles outside of the picture") {
  Kept kept;
  const auto countWith = [&](std::uint32_t tile) {
    std::string record = "Tile";
    for (int i = 0; i < 4; ++i) record += char(tile >> (8 * i) & 255);
    record += std::string(3 * 256, '\0');  // black pixels
    Sha256 sum;
    sum.add(kept.bytes.substr(32, 32));  // the fingerprint
    sum.add(record);
    const Digest digest = sum.finish();
    record.append(digest.begin(), digest.end());
    CHECK_EQUAL(record.size(), kHead + 3 * 256 + kSum);
    return countWhole(kept, kept.write("lies", kept.bytes.substr(0, kHeader) + record));
  };
  for (const std::uint32_t lie : {6u, 7u, 1u << 30, 0xffffffffu}) CHECK_EQUAL(countWith(lie), 0);
  CHECK_EQUAL(countWith(0), -1);  // no lie, and so taken, although it is black
}

TEST("a checkpoint of another picture, or what is none, is refused and stays as it is") {
  Kept kept;
  Pictures pictures;
  const auto refused = [&](const std::string& name, std::uint8_t value) {
    const std::string before = contentOf(name);
    try {
      const Checkpoint checkpoint(name, fingerprint(value), pictures.colorAlone());
    } catch (const UsageError&) {
      return contentOf(name) == before;
    }
    return false;
  };
  CHECK(refused(kept.name, 2));
  CHECK(!refused(kept.name, 1));
  CHECK(refused(kept.write("scene.txt", check::smallScene()), 1));
  CHECK(refused(kept.write("zeros", std::string(5000, '\0')), 1));
  std::string older = kept.bytes;
  older[older.find('3')] = '2';  // in the title; its fingerprint was another one too
  older[40] = char(older[40] ^ 1);
  CHECK(refused(kept.write("older", older), 1));
  CHECK(refused("/dev/null", 1));
  CHECK_THROWS(Checkpoint(kept.path(), fingerprint(1), pictures.targets()), OutputError);
  CHECK_THROWS(Checkpoint(kept.file("no/c"), fingerprint(1), pictures.targets()), OutputError);
}

TEST("one run has the file alone, from its opening to its removal") {
  Kept kept;
  Pictures pictures;
  Checkpoint first(kept.name, fingerprint(1), pictures.colorAlone());
  CHECK_THROWS(Checkpoint(kept.name, fingerprint(1), pictures.targets()), OutputError);
  CHECK_EQUAL(contentOf(kept.name), kept.bytes);
  first.remove();
  CHECK(!std::filesystem::exists(kept.name));
  Checkpoint next(kept.name, fingerprint(3), pictures.targets());
  CHECK_EQUAL(next.foundShare(), 0.0);
}
