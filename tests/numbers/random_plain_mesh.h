// Random closed meshes about 2 large around the origin: bent boxes, stars, rings.
#pragma once
#include <algorithm>

#include "plain_scene.h"
#include "random.h"

namespace numbers {

class RandomPlainMesh {
 public:
  /// `random` is not owned.
  explicit RandomPlainMesh(Random& random) : random_(random) {}

  /// Faces outwards, or in one of four all inwards.
  PlainMesh make() {
    const int kind = random_.index(3);
    PlainMesh made = kind == 0 ? ring() : kind == 1 ? box() : star();
    if (random_.index(4) == 0) {
      for (auto& face : made.faces) std::reverse(face.begin(), face.end());
    }
    return made;
  }

 private:
  /// Eight corners, moved a little: the sides are bent along a diagonal.
  PlainMesh box() {
    PlainMesh made;
    for (int i = 0; i < 8; ++i) {
      const Vec3d corner(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
      made.vertices.emplace_back(corner * 0.8 + random_.inCube(-0.2, 0.2));
    }
    made.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                  {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    return made;
  }
  /// An octahedron, each side divided into four, its corners at random distances.
  PlainMesh star() {
    PlainMesh made;
    for (int i = 0; i < 6; ++i) {
      Vec3d v;
      v[i / 2] = i % 2 ? -1 : 1;
      made.vertices.emplace_back(v);
    }
    for (int i = 0; i < 8; ++i) {
      const std::vector<int> corners = {i & 1 ? 1 : 0, i & 2 ? 3 : 2, i & 4 ? 5 : 4};
      const bool isTurned = ((i ^ (i >> 1) ^ (i >> 2)) & 1) != 0;
      divide(made, isTurned ? std::vector<int>{corners[0], corners[2], corners[1]} : corners);
    }
    for (Vec3f& v : made.vertices) {
      v = Vec3f(normalize(Vec3d(v)) * random_.uniform(0.6, 1.2));
    }
    return made;
  }
  static void divide(PlainMesh& made, const std::vector<int>& c) {
    int middles[3];
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3f sum =
          made.vertices[std::size_t(c[k])] + made.vertices[std::size_t(c[(k + 1) % 3])];
      const auto found = std::find(made.vertices.begin(), made.vertices.end(), sum);
      middles[k] = int(found - made.vertices.begin());
      if (found == made.vertices.end()) made.vertices.push_back(sum);
    }
    made.faces.push_back({c[0], middles[0], middles[2]});
    made.faces.push_back({c[1], middles[1], middles[0]});
    made.faces.push_back({c[2], middles[2], middles[1]});
    made.faces.push_back({middles[0], middles[1], middles[2]});
  }
  /// A ring of five-sided sections, wobbling.
  PlainMesh ring() {
    PlainMesh made;
    constexpr int kAround = 9, kSection = 5;
    for (int i = 0; i < kAround; ++i) {
      for (int k = 0; k < kSection; ++k) {
        const double a = 2 * math::kPi * i / kAround, b = 2 * math::kPi * k / kSection;
        const double thick = random_.uniform(0.25, 0.4), r = 0.8 + thick * math::cos(b);
        made.vertices.emplace_back(
            Vec3d(r * math::cos(a), thick * math::sin(b), -r * math::sin(a)));
      }
    }
    for (int i = 0; i < kAround; ++i) {
      for (int k = 0; k < kSection; ++k) {
        const int j = (i + 1) % kAround, l = (k + 1) % kSection;
        made.faces.push_back(
            {i * kSection + k, j * kSection + k, j * kSection + l, i * kSection + l});
      }
    }
    return made;
  }

  Random& random_;
};

}  // namespace numbers
