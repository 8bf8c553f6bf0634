// Colours that differ from place to place: between the pixels of a picture, and waves of noise.
#include "shading/diffuse_map.h"

#include <limits>

#include "math/functions.h"
#include "math/perlin_noise.h"
#include "shading/phong_material.h"
#include "vectors.h"

namespace {

/// Red and green above blue and white.
ImageTexture fourPixels() {
  Image image(2, 2);
  image.setPixel(0, 1, Rgb8{255, 0, 0});
  image.setPixel(1, 1, Rgb8{0, 255, 0});
  image.setPixel(0, 0, Rgb8{0, 0, 255});
  image.setPixel(1, 0, Rgb8{255, 255, 255});
  return ImageTexture(std::move(image));
}

const Vec3d kRed(1, 0, 0), kGreen(0, 1, 0), kBlue(0, 0, 1), kWhite(1, 1, 1);

Hit hitAt(const Vec3d& point, const Material* material = nullptr) {
  Hit hit;
  hit.record(1, material, {0, 0, 1}, point, {});
  return hit;
}

/// Always the same, so that what is made of it can be told.
class OneColor : public DiffuseMap {
 public:
  Vec3d colorAt(const Hit& hit, const Vec3f&) const override { return hit.getIntersectionPoint(); }
};

}  // namespace

TEST("a picture's pixels lie at whole numbers, from its upper left corner on") {
  const ImageTexture texture = fourPixels();
  // x = 2 u, y = 2 (1 - v).
  CHECK_EQUAL(texture.colorAt(0, 1), kRed);
  CHECK_EQUAL(texture.colorAt(0.5, 1), kGreen);
  CHECK_EQUAL(texture.colorAt(0, 0.5), kBlue);
  CHECK_EQUAL(texture.colorAt(0.5, 0.5), kWhite);
}

TEST("between pixels a picture has their mean, by the distance on each axis") {
  const ImageTexture texture = fourPixels();
  CHECK_EQUAL(texture.colorAt(0.125, 1), Vec3d(0.75, 0.25, 0));    // x = 1/4
  CHECK_EQUAL(texture.colorAt(0, 0.875), Vec3d(0.75, 0, 0.25));    // y = 1/4
  CHECK_EQUAL(texture.colorAt(0.25, 0.75), Vec3d(0.5, 0.5, 0.5));  // the middle of all four
  // x = 1/2 and y = 3/4: the upper mean (1/2, 1/2, 0) and the lower (1/2, 1/2, 1) as 1 to 3.
  CHECK_EQUAL(texture.colorAt(0.25, 0.625), Vec3d(0.5, 0.5, 0.75));
}

TEST("beyond a picture's outermost pixels these go on, however far") {
  const ImageTexture texture = fourPixels();
  const double most = std::numeric_limits<double>::max(),
               infinity = std::numeric_limits<double>::infinity();
  for (const double far : {1.0, 1e6, most, infinity}) {
    CHECK_EQUAL(texture.colorAt(-far, 1 + far), kRed);
    CHECK_EQUAL(texture.colorAt(far, 1 + far), kGreen);
    CHECK_EQUAL(texture.colorAt(-far, -far), kBlue);
    CHECK_EQUAL(texture.colorAt(far, -far), kWhite);
  }
  CHECK_EQUAL(texture.colorAt(1, 0), kWhite);
  CHECK_EQUAL(texture.colorAt(0.75, 0.25), kWhite);  // x and y are 3/2
}

TEST("a place that is no number is the left, or the top, of a picture") {
  const double none = std::numeric_limits<double>::quiet_NaN();
  CHECK_EQUAL(fourPixels().colorAt(none, 0), kBlue);
  CHECK_EQUAL(fourPixels().colorAt(1, none), kGreen);
}

TEST("a picture of one pixel has its colour everywhere, and takes three bytes") {
  Image image(1, 1);
  image.setPixel(0, 0, Rgb8{51, 102, 255});
  const ImageTexture texture(std::move(image));
  CHECK_EQUAL(texture.colorAt(0.3, 0.9), Vec3d(51 / 255.0, 102 / 255.0, 1));
  CHECK_EQUAL(texture.byteCount(), std::size_t(3));
}

TEST("noise mixes two colours in waves across the x axis") {
  const Vec3f first(0.9f, 0.1f, 0), second(0, 0.2f, 1);
  const NoiseMap map(first, second, {3, 5, 2.5});
  double least = 1, most = 0;
  for (const Vec3d p : {Vec3d(0.3, -1.2, 2.5), Vec3d(-4.4, 0.7, 0.1), Vec3d(7.25, 3, -2.6)}) {
    const double n = math::noise(p) + math::noise(p * 2) / 2 + math::noise(p * 4) / 4;
    const double w = (1 + math::sin(5 * p.x() + 2.5 * n)) / 2;
    CHECK_NEAR_VECTOR(map.colorAt(hitAt(p), Vec3f()), Vec3d(first) * w + Vec3d(second) * (1 - w),
                      1e-12);
    least = std::min(least, w);
    most = std::max(most, w);
  }
  CHECK(most - least > 0.2);
}

TEST("without octaves noise is a plain sine: all of the first colour at its top") {
  const NoiseMap map({1, 0, 0}, {0, 1, 0}, {0, 1, 9});
  const double quarter = math::radians(90);
  CHECK_NEAR_VECTOR(map.colorAt(hitAt({quarter, 5, 5}), Vec3f()), kRed, 1e-15);
  CHECK_NEAR_VECTOR(map.colorAt(hitAt({-quarter, 5, 5}), Vec3f()), kGreen, 1e-15);
  CHECK_EQUAL(map.colorAt(hitAt({0, 5, 5}), Vec3f()), Vec3d(0.5, 0.5, 0));
}

TEST("where noise has no angle there is only the second colour") {
  const NoiseMap map({1, 0, 0}, {0, 1, 0}, {2, 1e300, 1});
  CHECK_EQUAL(map.colorAt(hitAt({1e300, 0, 0}), Vec3f()), kGreen);
}

TEST("a map takes the place of a material's diffuse colour, and of nothing else") {
  const OneColor map;
  const Vec3d place(0.2, 0.4, 0.6);
  const Ray ray({0, 0, 5}, {0, 0, -1});
  const Vec3f toLight(0, 0.6f, 0.8f), light(1, 0.5f, 0.25f), specular(0.3f, 0.2f, 0.1f);
  const auto check = [&](auto&& mapped, const auto& plain) {
    mapped.setDiffuseMap(&map);
    CHECK_EQUAL(mapped.getDiffuseMap(), &map);
    const Hit hit = hitAt(place);
    // place is the diffuse colour there, but in double.
    CHECK_NEAR_VECTOR(mapped.Shade(ray, hit, toLight, light), plain.Shade(ray, hit, toLight, light),
                      1e-7);
    CHECK_EQUAL(mapped.getDiffuseColor(), Vec3f(1, 1, 0));
  };
  check(PhongMaterial({1, 1, 0}, specular, 7, {}, {}, 1),
        PhongMaterial(Vec3f(place), specular, 7, {}, {}, 1));
  check(BlinnPhongMaterial({1, 1, 0}, specular, 7, {}, {}, 1),
        BlinnPhongMaterial(Vec3f(place), specular, 7, {}, {}, 1));
}

TEST("where an object has no texture coordinates, a picture leaves the plain colour") {
  const ImageTexture texture = fourPixels();
  const DiffuseMap& map = texture;
  CHECK_EQUAL(map.colorAt(hitAt({1, 2, 3}), Vec3f(0.5f, 0.25f, 0)), Vec3d(0.5, 0.25, 0));
}
