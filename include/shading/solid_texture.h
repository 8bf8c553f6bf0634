// SolidTexture: a material that is mixed, point by point in space, from two others; and the five
// kinds of it, which differ in how much of the second material there is at a point.
//
// What a texture is made of may be textures again, to any depth; at every point it comes down to a
// few plain materials, each with a weight, and the ray tracer treats the point as each of them in
// turn. A texture lies in space, not on a surface: `toTexture` takes a point of the world to the
// space in which the pattern is described, so the objects look as if carved out of it.
#pragma once
#include <cstddef>
#include <vector>

#include "math/matrix.h"
#include "shading/material.h"

/// A plain material (none that is a texture) and its share in a point, above 0 and at most 1.
struct WeightedMaterial {
  const Material* material;  ///< not owned
  double weight;
};

class SolidTexture : public Material {
 public:
  /// A material as a texture refers to it: not owned. Every material of a scene has a place of its
  /// own, and textures refer only to places before theirs.
  struct Component {
    const Material* material;
    std::size_t place;
  };

  /// `toTexture` may be singular. As a Material the texture has, channel by channel, the largest of
  /// its components' colours, so that neither is transparent or reflective where the texture says
  /// that it is not, and the index and priority of the first.
  SolidTexture(const Matrix& toTexture, const Component& first, const Component& second);

  /// What a texture comes down to at a point: plain materials. Who asks for many points keeps one,
  /// and so its memory.
  class Mixture {
   public:
    auto begin() const { return plain_.begin(); }
    auto end() const { return plain_.end(); }
    std::size_t size() const { return plain_.size(); }
    const WeightedMaterial& operator[](std::size_t i) const { return plain_[i]; }

   private:
    friend class SolidTexture;

    /// A share of a component that is still to be looked at.
    struct Waiting {
      Component component;
      double weight;
      std::size_t arrival;  // of two shares of one component, the first comes first

      bool operator<(const Waiting& other) const {
        return component.place != other.component.place ? component.place < other.component.place
                                                        : arrival > other.arrival;
      }
    };
    void add(const Component& component, double weight);
    WeightedMaterial takeLatest();

    std::vector<WeightedMaterial> plain_;
    std::vector<Waiting> waiting_;  // a heap, the latest place on top
    std::size_t arrivals_ = 0;
  };

  /// Sets `mixture` to the plain materials at a point of the world, each once, latest place first;
  /// their weights add up to 1 but for rounding. Never empty. Takes time in proportion to the
  /// textures below this one (a texture that is reached in many ways is looked at once), and no
  /// stack.
  void mixAt(const Vec3d& point, Mixture& mixture) const;
  Mixture materialsAt(const Vec3d& point) const {
    Mixture mixture;
    mixAt(point, mixture);
    return mixture;
  }

  /// The mean of the components' light, by weight, at the point that was hit.
  Vec3f Shade(const Ray& ray, const Hit& hit, const Vec3f& dirToLight,
              const Vec3f& lightColor) const override;
  const SolidTexture* asTexture() const override { return this; }

 private:
  /// The weight of the second component at a point of the texture's space. Below 0 counts as 0,
  /// above 1 as 1, NaN as 0.
  virtual double weightOfSecond(const Vec3d& p) const = 0;

  double clampedWeight(const Vec3d& point) const;

  Matrix toTexture_;
  Component first_, second_;
};

/// Space in cubes of the two materials by turns.
class Checkerboard : public SolidTexture {
 public:
  /// size > 0 is the side of a cube. The first material is where floor(x / size) +
  /// floor(y / size) + floor(z / size) is even, (x, y, z) in the texture's space.
  Checkerboard(const Matrix& toTexture, const Component& first, const Component& second,
               double size = 1)
      : SolidTexture(toTexture, first, second), size_(size) {}
  const char* getKind() const override { return "Checkerboard"; }

 private:
  double weightOfSecond(const Vec3d& p) const override;

  double size_;
};

/// Soft clouds: the second material has the weight 1/2 + slope N, N being math::fractalNoise.
class Noise : public SolidTexture {
 public:
  /// 0 <= octaves <= math::kMaxOctaves; slope is any finite number.
  Noise(const Matrix& toTexture, const Component& first, const Component& second, int octaves,
        double slope = 0.5)
      : SolidTexture(toTexture, first, second), octaves_(octaves), slope_(slope) {}
  const char* getKind() const override { return "Noise"; }

 private:
  double weightOfSecond(const Vec3d& p) const override;

  int octaves_;
  double slope_;
};

/// Waves along a distance d, disturbed by noise: the second material has the weight
/// (1 + height sin(frequency d + amplitude N)) / 2. Where the sine is NaN (an infinite angle) there
/// is only the first.
class WaveTexture : public SolidTexture {
 public:
  /// octaves as for Noise; frequency in radians per unit of the texture's space, amplitude in
  /// radians, both any finite number; height 1, or -1, which exchanges the materials.
  WaveTexture(const Matrix& toTexture, const Component& first, const Component& second, int octaves,
              double frequency, double amplitude, double height = 1)
      : SolidTexture(toTexture, first, second),
        octaves_(octaves),
        frequency_(frequency),
        amplitude_(amplitude),
        height_(height) {}

 private:
  double weightOfSecond(const Vec3d& p) const override;
  virtual double distanceAt(const Vec3d& p) const = 0;

  int octaves_;
  double frequency_, amplitude_, height_;
};

/// Layers across the x axis: d is x.
class Marble : public WaveTexture {
 public:
  using WaveTexture::WaveTexture;
  const char* getKind() const override { return "Marble"; }

 private:
  double distanceAt(const Vec3d& p) const override;
};

/// Rings around the y axis: d is the distance from it.
class Wood : public WaveTexture {
 public:
  using WaveTexture::WaveTexture;
  const char* getKind() const override { return "Wood"; }

 private:
  double distanceAt(const Vec3d& p) const override;
};

/// Wood with narrow dark rings and a long grain: rings around the y axis that lean a little, and
/// noise that is stretched five times along it. The first material has the weight s^2, with
///   s = 1/2 + sin(frequency (sqrt(x^2 + z^2) + 0.05 y) + amplitude N(x, 0.2 y, z)), within 0..1.
class GrainedWood : public SolidTexture {
 public:
  /// As for WaveTexture.
  GrainedWood(const Matrix& toTexture, const Component& first, const Component& second, int octaves,
              double frequency, double amplitude)
      : SolidTexture(toTexture, first, second),
        octaves_(octaves),
        frequency_(frequency),
        amplitude_(amplitude) {}
  const char* getKind() const override { return "Wood"; }

 private:
  double weightOfSecond(const Vec3d& p) const override;

  int octaves_;
  double frequency_, amplitude_;
};
