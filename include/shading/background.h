// Background: what a ray sees that meets nothing: one colour, or, by its direction, the inside of a
// large cube that is painted with six pictures (CubeMap).
// Sources: MIT 6.837, "Introduction to Computer Graphics", assignments of 2012 and 2016.
#pragma once
#include <array>
#include <optional>
#include <string_view>

#include "math/vec3.h"
#include "shading/diffuse_map.h"

/// Six pictures around the world, infinitely far away: only a ray's direction counts.
class CubeMap {
 public:
  /// The faces by the files' names, in the order of the constructor's pictures; they lie in the
  /// directions -x, +x, +y, -y, +z and -z.
  static constexpr std::string_view kFaces[] = {"left", "right", "up", "down", "front", "back"};
  using Pictures = std::array<const ImageTexture*, std::size(kFaces)>;

  /// None is null or owned; they may differ in size.
  explicit CubeMap(const Pictures& pictures) : pictures_(pictures) {}

  /// The colour in a direction of any length, each component 0..1. The largest component by size
  /// says which face is seen; of equals the first of x, y, z. Of the zero vector, and of one that
  /// has a NaN, it is a colour of some face.
  Vec3d colorAt(const Vec3d& direction) const;

 private:
  Pictures pictures_;
};

class Background {
 public:
  Background() = default;
  explicit Background(const Vec3f& color, const std::optional<CubeMap>& cubeMap = {})
      : color_(color), cubeMap_(cubeMap) {}

  /// What is seen where there is no cube map.
  const Vec3f& getColor() const { return color_; }

  /// What a ray of that direction sees, of any length.
  Vec3f colorAt(const Vec3d& direction) const {
    return cubeMap_ ? Vec3f(cubeMap_->colorAt(direction)) : color_;
  }

 private:
  Vec3f color_{0.5f, 0.5f, 0.5f};
  std::optional<CubeMap> cubeMap_;
};
