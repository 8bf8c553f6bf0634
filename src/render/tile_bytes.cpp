// The pixels of a tile as bytes.
#include "render/tile_bytes.h"

#include <array>
#include <cstring>

namespace {

/// One of the two is null, or both where the picture is not wanted.
struct Picture {
  Image* image;
  FloatImage* exact;
  int zoom;

  bool isWanted() const { return image || exact; }
  std::size_t bytesOfPixel() const { return image ? 3 : 12; }
};

/// All kinds, in the order of their bits.
std::array<Picture, kPictureKinds> picturesOf(const RenderTargets& targets) {
  return {{{targets.color, nullptr, 1},
           {targets.depth, nullptr, 1},
           {targets.normals, nullptr, 1},
           {targets.samples, nullptr, targets.samplesZoom},
           {nullptr, targets.color ? targets.exactColor : nullptr, 1},
           {nullptr, targets.depth ? targets.exactDepth : nullptr, 1},
           {nullptr, targets.normals ? targets.exactNormals : nullptr, 1}}};
}

void appendFloat(float value, Bytes& bytes) {
  std::uint32_t bits = 0;
  static_assert(sizeof bits == sizeof value);
  std::memcpy(&bits, &value, sizeof bits);
  for (int i = 0; i < 4; ++i) bytes.push_back(std::uint8_t(bits >> (8 * i) & 255));
}

float floatAt(const std::uint8_t* bytes) {
  std::uint32_t bits = 0;
  for (int i = 0; i < 4; ++i) bits |= std::uint32_t(bytes[i]) << (8 * i);
  float value = 0;
  std::memcpy(&value, &bits, sizeof bits);
  return value;
}

/// Calls visit(picture, x, y) for all pixels of `area` in their order.
template <class Visit>
void forEachPixel(const RenderTargets& targets, const PixelRectangle& area, const Visit& visit) {
  for (const Picture& picture : picturesOf(targets)) {
    if (!picture.isWanted()) continue;
    for (int y = area.bottom * picture.zoom; y < area.top * picture.zoom; ++y) {
      for (int x = area.left * picture.zoom; x < area.right * picture.zoom; ++x) {
        visit(picture, x, y);
      }
    }
  }
}

}  // namespace

unsigned pictureBits(const RenderTargets& targets) {
  unsigned bits = 0, bit = 1;
  for (const Picture& picture : picturesOf(targets)) {
    if (picture.isWanted()) bits |= bit;
    bit *= 2;
  }
  return bits;
}

RenderTargets withPictures(const RenderTargets& targets, unsigned bits) {
  RenderTargets some = targets;
  if (!(bits & 1)) some.color = nullptr;
  if (!(bits & 2)) some.depth = nullptr;
  if (!(bits & 4)) some.normals = nullptr;
  if (!(bits & 8)) some.samples = nullptr;
  if (!(bits & 16)) some.exactColor = nullptr;
  if (!(bits & 32)) some.exactDepth = nullptr;
  if (!(bits & 64)) some.exactNormals = nullptr;
  return some;
}

std::size_t tileByteCount(const RenderTargets& targets, const PixelRectangle& area) {
  std::size_t bytes = 0;
  for (const Picture& picture : picturesOf(targets)) {
    const auto zoom = std::size_t(picture.zoom);
    if (picture.isWanted()) bytes += area.pixelCount() * zoom * zoom * picture.bytesOfPixel();
  }
  return bytes;
}

void appendTileBytes(const RenderTargets& targets, const PixelRectangle& area, Bytes& bytes) {
  bytes.reserve(bytes.size() + tileByteCount(targets, area));
  forEachPixel(targets, area, [&](const Picture& picture, int x, int y) {
    if (picture.image) {
      const Rgb8 pixel = picture.image->getPixel(x, y);
      bytes.insert(bytes.end(), {pixel.r, pixel.g, pixel.b});
    } else {
      const Vec3f& color = picture.exact->getPixel(x, y);
      for (const float value : {color.x(), color.y(), color.z()}) appendFloat(value, bytes);
    }
  });
}

void setTileBytes(const RenderTargets& targets, const PixelRectangle& area,
                  const std::uint8_t* bytes) {
  forEachPixel(targets, area, [&](const Picture& picture, int x, int y) {
    if (picture.image) {
      picture.image->setPixel(x, y, Rgb8{bytes[0], bytes[1], bytes[2]});
    } else {
      picture.exact->setPixel(x, y, {floatAt(bytes), floatAt(bytes + 4), floatAt(bytes + 8)});
    }
    bytes += picture.bytesOfPixel();
  });
}
