// Light: the two kinds of the assignment.
#include "shading/light.h"

#include <limits>

void DirectionalLight::getIllumination(const Vec3d&, Vec3d& dirToLight, Vec3f& color,
                                       double& distanceToLight) const {
  dirToLight = dirToLight_;
  color = color_;
  distanceToLight = std::numeric_limits<double>::infinity();
}

void PointLight::getIllumination(const Vec3d& point, Vec3d& dirToLight, Vec3f& color,
                                 double& distanceToLight) const {
  const Vec3d way = position_ - point;
  const double s = length(way);
  dirToLight = s > 0 ? way / s : Vec3d();
  const double dimming = attenuation_.x() + attenuation_.y() * s + attenuation_.z() * (s * s);
  color = Vec3f(Vec3d(color_) / dimming);
  distanceToLight = s;
}
