// The scene of the whole-program rows: our scene file and the rival's constants say the same.
#pragma once
#include <string>

#include "math/vec3.h"

namespace bench {

struct Surface {
  Vec3f diffuse, specular;
  float exponent;
  Vec3f transparent, reflective;
  float index;
};

inline constexpr Surface kMeshSurface{{0.7f, 0.6f, 0.5f}, {0.3f, 0.3f, 0.3f}, 20,
                                      {0, 0, 0},          {0.2f, 0.2f, 0.2f}, 1};
inline constexpr Surface kFloorSurface{{0.2f, 0.2f, 0.3f}, {0, 0, 0},          1,
                                       {0, 0, 0},          {0.7f, 0.7f, 0.7f}, 1};
inline constexpr Surface kGlassSurface{{0, 0, 0},          {1, 1, 1},          50,
                                       {0.9f, 0.9f, 0.9f}, {0.2f, 0.2f, 0.2f}, 1.5f};

inline constexpr Vec3f kEye(0, 6, 34), kView(0, -0.2f, -1);
inline constexpr float kViewAngle = 50;  ///< degrees
inline constexpr Vec3f kLightPlace(25, 30, 25), kLightColor(0.9f, 0.9f, 0.9f);
inline constexpr Vec3f kBackground(0.3f, 0.4f, 0.6f), kAmbient(0.1f, 0.1f, 0.1f);
inline constexpr Vec3f kBallCenter(6, -4, 16);
inline constexpr float kBallRadius = 5, kFloorHeight = -12;
inline constexpr int kBounces = 5;
inline constexpr float kMinWeight = 0.01f, kRayEpsilon = 0.001f;

/// Our scene file; the mesh lies beside it.
std::string programScene(const std::string& objName);

}  // namespace bench
