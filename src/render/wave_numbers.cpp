// Cameras, lights and materials as the numbers that the kernels of a wave take.
//
// Each class that has a wide form is known here, itself and not what is derived from it, which may
// compute otherwise.
#include "render/sample_tracing.h"
#include "render/wave_kernels.h"

namespace {

void copyTo(double (&numbers)[3], const Vec3d& v) {
  for (int axis = 0; axis < 3; ++axis) numbers[axis] = v[axis];
}
void copyTo(double (&numbers)[2], const Vec2d& v) {
  numbers[0] = v.x();
  numbers[1] = v.y();
}

}  // namespace

bool toNumbers(const PictureView& view, EyeFrame& eye) {
  const Camera& camera = view.camera;
  copyTo(eye.center, camera.getCenter());
  copyTo(eye.direction, camera.getDirection());
  copyTo(eye.right, camera.getRight());
  copyTo(eye.up, camera.getUp());
  const auto* perspective = exactly<PerspectiveCamera>(&camera);
  const auto* orthographic = exactly<OrthographicCamera>(&camera);
  copyTo(eye.middle, view.middle());
  copyTo(eye.unit, view.unit());
  eye.isPerspective = perspective;
  if (perspective) eye.scale = perspective->getSpread();
  if (orthographic) eye.scale = orthographic->getSize();
  return perspective || orthographic;
}

bool toNumbers(const Light& light, LightNumbers& numbers) {
  const auto* directional = exactly<DirectionalLight>(&light);
  const auto* point = exactly<PointLight>(&light);
  if (!directional && !point) return false;
  numbers.isPoint = point;
  copyTo(numbers.place, point ? point->getPosition() : directional->getDirToLight());
  copyTo(numbers.color, point ? point->getColor() : directional->getColor());
  if (point) copyTo(numbers.attenuation, point->getAttenuation());
  return true;
}

bool toNumbers(const Material& material, PhongNumbers& numbers) {
  numbers.isBlinn = exactly<BlinnPhongMaterial>(&material);
  if (!numbers.isBlinn && !exactly<PhongMaterial>(&material)) return false;
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
