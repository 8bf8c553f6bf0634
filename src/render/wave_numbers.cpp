// Cameras, lights and materials as the numbers that the kernels of a wave take.
//
// Each class that has a wide form is known here, itself and not what is derived from it, which may
// compute otherwise.
#include <typeinfo>

#include "render/wave_kernels.h"

namespace {

void copyTo(double (&numbers)[3], const Vec3d& v) {
  for (int axis = 0; axis < 3; ++axis) numbers[axis] = v[axis];
}

}  // namespace

bool toNumbers(const Camera& camera, EyeFrame& eye) {
  copyTo(eye.center, camera.getCenter());
  copyTo(eye.direction, camera.getDirection());
  copyTo(eye.right, camera.getRight());
  copyTo(eye.up, camera.getUp());
  eye.isPerspective = typeid(camera) == typeid(PerspectiveCamera);
  if (eye.isPerspective) {
    eye.scale = static_cast<const PerspectiveCamera&>(camera).getSpread();
    return true;
  }
  if (typeid(camera) != typeid(OrthographicCamera)) return false;
  eye.scale = static_cast<const OrthographicCamera&>(camera).getSize();
  return true;
}

bool toNumbers(const Light& light, LightNumbers& numbers) {
  if (typeid(light) == typeid(DirectionalLight)) {
    const auto& directional = static_cast<const DirectionalLight&>(light);
    numbers.isPoint = false;
    copyTo(numbers.place, directional.getDirToLight());
    copyTo(numbers.color, directional.getColor());
    return true;
  }
  if (typeid(light) != typeid(PointLight)) return false;
  const auto& point = static_cast<const PointLight&>(light);
  numbers.isPoint = true;
  copyTo(numbers.place, point.getPosition());
  copyTo(numbers.color, point.getColor());
  copyTo(numbers.attenuation, point.getAttenuation());
  return true;
}

bool toNumbers(const Material& material, PhongNumbers& numbers) {
  numbers.isBlinn = typeid(material) == typeid(BlinnPhongMaterial);
  if (!numbers.isBlinn && typeid(material) != typeid(PhongMaterial)) return false;
  const auto& phong = static_cast<const PhongMaterial&>(material);
  if (phong.getDiffuseMap()) return false;
  copyTo(numbers.diffuse, phong.getDiffuseColor());
  copyTo(numbers.specular, phong.getSpecularColor());
  numbers.exponent = double(phong.getExponent());
  numbers.highlight = phong.getHighlight();
  return true;
}

const WaveKernels& waveKernels(SimdLevel level) {
  static const WaveKernels kBaseline = baseline::waveKernels(), kAvx2 = avx2::waveKernels(),
                           kAvx512 = avx512::waveKernels();
  return level == SimdLevel::avx512 ? kAvx512 : level == SimdLevel::avx2 ? kAvx2 : kBaseline;
}
