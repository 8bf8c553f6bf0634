// The background: one colour, or a cube of six pictures that a direction is looked up in.
#include "shading/background.h"

#include <limits>
#include <memory>

#include "vectors.h"

namespace {

enum Face { left, right, up, down, front, back };

/// A cube whose colours tell face, column and row.
class MarkedCube {
 public:
  MarkedCube() {
    CubeMap::Pictures pictures;
    for (int face = 0; face < 6; ++face) {
      const int side = sideOf(face);
      Image image(side, side);
      for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
          image.setPixel(
              x, y,
              Rgb8{std::uint8_t(face), std::uint8_t(10 * x), std::uint8_t(10 * (side - 1 - y))});
        }
      }
      textures_.push_back(std::make_unique<ImageTexture>(std::move(image)));
      pictures[std::size_t(face)] = textures_.back().get();
    }
    map_.emplace(pictures);
  }

  const CubeMap& map() const { return *map_; }
  /// Of place (u, v), from the face's lower left corner on, where no pixel is the last one.
  static Vec3d colorOf(Face face, double u, double v) {
    const int side = sideOf(face);
    return Vec3d(face, 10 * u * side, 10 * (1 - v) * side) / 255;
  }

 private:
  static int sideOf(int face) { return 8 + 2 * face; }

  std::vector<std::unique_ptr<ImageTexture>> textures_;
  std::optional<CubeMap> map_;
};

}  // namespace

TEST("a background without a cube map has one colour in all directions") {
  CHECK_EQUAL(Background().colorAt({1, 2, 3}), Vec3f(0.5f, 0.5f, 0.5f));
  const Background background({0.1f, 2, -3});
  CHECK_EQUAL(background.colorAt({0, 0, -1}), Vec3f(0.1f, 2, -3));
  CHECK_EQUAL(background.getColor(), Vec3f(0.1f, 2, -3));
}

TEST("the middle of each face of a cube map lies on an axis") {
  const MarkedCube cube;
  const Background background({1, 1, 1}, cube.map());
  const auto check = [&](Face face, const Vec3d& direction) {
    CHECK_NEAR_VECTOR(cube.map().colorAt(direction), MarkedCube::colorOf(face, 0.5, 0.5), 1e-15);
    CHECK_EQUAL(background.colorAt(direction), Vec3f(cube.map().colorAt(direction)));
  };
  check(right, {1, 0, 0});
  check(left, {-3, 0, 0});
  check(up, {0, 1, 0});
  check(down, {0, -0.5, 0});
  check(front, {0, 0, 1});
  check(back, {0, 0, -1});
}

// The quotients are 1/2 and -1/2, so places are 1/4 and 3/4.
TEST("off its middle each face of a cube map lies as the course's pictures do") {
  const MarkedCube cube;
  const auto check = [&](Face face, const Vec3d& direction, double u, double v) {
    CHECK_NEAR_VECTOR(cube.map().colorAt(direction), MarkedCube::colorOf(face, u, v), 1e-15);
  };
  check(right, {2, 1, -1}, 0.25, 0.75);  // looking along +x: +z is to the right, +y up
  check(left, {-2, 1, -1}, 0.75, 0.75);  // -z to the right, +y up
  check(up, {1, 2, -1}, 0.75, 0.25);     // +x to the right, +z up
  check(down, {1, -2, -1}, 0.75, 0.25);  // +x to the right, +z up
  check(front, {1, 1, 2}, 0.25, 0.75);   // -x to the right, +y up
  check(back, {1, 1, -2}, 0.25, 0.75);   // -x to the right, +y up
  // Each axis of a face by itself, so that none can stand for the other.
  check(right, {4, 1, 0}, 0.5, 0.625);
  check(left, {-4, 1, 0}, 0.5, 0.625);
  check(up, {1, 4, 0}, 0.625, 0.5);
  check(down, {1, -4, 0}, 0.625, 0.5);
  check(front, {1, 0, 4}, 0.375, 0.5);
  check(back, {1, 0, -4}, 0.375, 0.5);
}

TEST("on an edge of a cube map the first of x, y and z has the direction") {
  const MarkedCube cube;
  const auto faceAt = [&](const Vec3d& direction) {
    return Face(int(cube.map().colorAt(direction).x() * 255 + 0.5));
  };
  CHECK_EQUAL(faceAt({1, -1, 1}), right);
  CHECK_EQUAL(faceAt({-1, 0, 1}), left);
  CHECK_EQUAL(faceAt({0, 1, -1}), up);
  CHECK_EQUAL(faceAt({0.5, -1, 1}), down);
}

TEST("only the direction of a ray counts for a cube map, not its length") {
  const MarkedCube cube;
  for (const double length : {0x1p-500, 1.0, 0x1p500}) {
    CHECK_EQUAL(cube.map().colorAt(Vec3d(0.3, -0.2, 0.5) * length),
                cube.map().colorAt(Vec3d(0.3, -0.2, 0.5)));
  }
}

TEST("a direction that is none has a colour of some face") {
  const MarkedCube cube;
  const double none = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  for (const Vec3d direction : {Vec3d(), Vec3d(none, 0, 0), Vec3d(0, none, none),
                                Vec3d(infinity, infinity, 0), Vec3d(none, none, none)}) {
    const Vec3d color = cube.map().colorAt(direction);
    for (int k = 0; k < 3; ++k) CHECK(color[k] >= 0 && color[k] <= 1);
  }
}
