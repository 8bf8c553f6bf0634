// The pixels of a tile as bytes. A table names the kinds of pictures in the order of their bits, so
// that every function goes through them in that one order.
#include "render/tile_bytes.h"

#include <cassert>
#include <cstring>

namespace {

/// Where RenderTargets has a picture: bytes or exact floats, the other one being null.
struct Kind {
  Image* RenderTargets::*image;
  FloatImage* RenderTargets::*exact;

  bool isIn(const RenderTargets& targets) const {
    return image ? targets.*image != nullptr : targets.*exact != nullptr;
  }
  int zoomIn(const RenderTargets& targets) const {
    return image == &RenderTargets::samples ? targets.samplesZoom : 1;
  }
  std::size_t bytesOfPixel() const { return image ? 3 : 12; }
};

constexpr Kind kKinds[kPictureKinds] = {
    {&RenderTargets::color, nullptr},        {&RenderTargets::depth, nullptr},
    {&RenderTargets::normals, nullptr},      {&RenderTargets::samples, nullptr},
    {nullptr, &RenderTargets::exactColor},   {nullptr, &RenderTargets::exactDepth},
    {nullptr, &RenderTargets::exactNormals}, {&RenderTargets::materials, nullptr}};

/// Calls visit(kind, x, y) for all pixels of `area` in all pictures, in their order.
template <class Visit>
void forEachPixel(const RenderTargets& targets, const PixelRectangle& area, const Visit& visit) {
  for (const Kind& kind : kKinds) {
    if (!kind.isIn(targets)) continue;
    const int zoom = kind.zoomIn(targets);
    for (int y = area.bottom * zoom; y < area.top * zoom; ++y) {
      for (int x = area.left * zoom; x < area.right * zoom; ++x) visit(kind, x, y);
    }
  }
}

/// The bits as they are, NaN included.
void appendFloat(float value, Bytes& bytes) {
  std::uint32_t bits = 0;
  static_assert(sizeof bits == sizeof value);
  std::memcpy(&bits, &value, sizeof bits);
  appendNumber(bits, bytes);
}

float floatAt(const std::uint8_t* bytes) {
  const std::uint32_t bits = numberAt(bytes);
  float value = 0;
  std::memcpy(&value, &bits, sizeof bits);
  return value;
}

}  // namespace

std::uint32_t pictureBits(const RenderTargets& targets) {
  std::uint32_t bits = 0;
  for (int i = 0; i < kPictureKinds; ++i) bits |= std::uint32_t(kKinds[i].isIn(targets)) << i;
  return bits;
}

/// Exact floats have bits of their own, but never come without the picture of the same name.
RenderTargets withPictures(const RenderTargets& targets, std::uint32_t bits) {
  RenderTargets some = targets;
  for (int i = 0; i < kPictureKinds; ++i) {
    if ((bits >> i & 1) != 0) continue;
    if (kKinds[i].image) some.*kKinds[i].image = nullptr;
    if (kKinds[i].exact) some.*kKinds[i].exact = nullptr;
  }
  return some;
}

PixelRectangle wholeArea(const RenderTargets& targets) {
  for (const Kind& kind : kKinds) {
    if (!kind.image || !kind.isIn(targets)) continue;
    const Image& image = *(targets.*kind.image);
    const int zoom = kind.zoomIn(targets);
    return {0, 0, image.Width() / zoom, image.Height() / zoom};
  }
  assert(false);
  return {0, 0, 0, 0};
}

std::size_t tileByteCount(const RenderTargets& targets, const PixelRectangle& area) {
  std::size_t bytes = 0;
  for (const Kind& kind : kKinds) {
    const auto zoom = std::size_t(kind.zoomIn(targets));
    if (kind.isIn(targets)) bytes += area.pixelCount() * zoom * zoom * kind.bytesOfPixel();
  }
  return bytes;
}

/// Called while other threads write to other tiles: it reads no pixel outside `area`.
Bytes tileBytes(const RenderTargets& targets, const PixelRectangle& area) {
  Bytes bytes;
  bytes.reserve(tileByteCount(targets, area));
  forEachPixel(targets, area, [&](const Kind& kind, int x, int y) {
    if (kind.image) {
      const Rgb8 pixel = (targets.*kind.image)->getPixel(x, y);
      bytes.insert(bytes.end(), {pixel.r, pixel.g, pixel.b});
    } else {
      const Vec3f& color = (targets.*kind.exact)->getPixel(x, y);
      for (const float value : {color.x(), color.y(), color.z()}) appendFloat(value, bytes);
    }
  });
  return bytes;
}

void setTileBytes(const RenderTargets& targets, const PixelRectangle& area,
                  const std::uint8_t* bytes) {
  forEachPixel(targets, area, [&](const Kind& kind, int x, int y) {
    if (kind.image) {
      (targets.*kind.image)->setPixel(x, y, Rgb8{bytes[0], bytes[1], bytes[2]});
    } else {
      const Vec3f color(floatAt(bytes), floatAt(bytes + 4), floatAt(bytes + 8));
      (targets.*kind.exact)->setPixel(x, y, color);
    }
    bytes += kind.bytesOfPixel();
  });
}

void appendNumber(std::uint32_t number, Bytes& bytes) {
  for (int i = 0; i < 4; ++i) bytes.push_back(std::uint8_t(number >> (8 * i) & 255));
}

std::uint32_t numberAt(const std::uint8_t* bytes) {
  std::uint32_t number = 0;
  for (int i = 0; i < 4; ++i) number |= std::uint32_t(bytes[i]) << (8 * i);
  return number;
}
