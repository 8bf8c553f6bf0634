// Every class and signature of the assignment, called the way the assignment writes it: with Vec3f
// and float arguments. That this file compiles and links is most of the test.
#include "camera/camera.h"
#include "geometry/group.h"
#include "geometry/plane.h"
#include "geometry/sphere.h"
#include "geometry/transform.h"
#include "geometry/triangle.h"
#include "geometry/triangle_mesh.h"
#include "image/image.h"
#include "math/vec3.h"
#include "render/ray_tracer.h"
#include "scene/scene_parser.h"
#include "scene_text.h"
#include "shading/light.h"
#include "shading/optics.h"
#include "shading/phong_material.h"
#include "vectors.h"

namespace {

/// A material as a student would add one.
class FlatMaterial : public Material {
 public:
  FlatMaterial(const Vec3f& diffuseColor, const Vec3f& transparentColor,
               const Vec3f& reflectiveColor, float indexOfRefraction)
      : Material(diffuseColor, transparentColor, reflectiveColor, indexOfRefraction) {}
  Vec3f Shade(const Ray&, const Hit&, const Vec3f&, const Vec3f& lightColor) const override {
    return lightColor * getDiffuseColor();
  }
};

const char* const kScene =
    "Lights { numLights 1 DirectionalLight { direction 0 0 -1 color 1 1 1 } }"
    "Background { color 0.25 0.5 0.75 ambientLight 0.5 0.5 0.5 }"
    "Materials { numMaterials 1 PhongMaterial { diffuseColor 0.5 0.25 0.125 } }"
    "Group { numObjects 1 MaterialIndex 0 Sphere { center 0 0 0 radius 1 } }";

}  // namespace

TEST("materials are made, asked and shaded as the assignment writes it") {
  const Vec3f diffuseColor(0.5f, 0.25f, 1), specularColor(0, 0, 0), transparentColor(0.1f, 0, 0),
      reflectiveColor(0, 0.1f, 0);
  float exponent = 10, indexOfRefraction = 1.5f;
  const PhongMaterial phong(diffuseColor, specularColor, exponent, transparentColor,
                            reflectiveColor, indexOfRefraction);
  const FlatMaterial flat(diffuseColor, transparentColor, reflectiveColor, indexOfRefraction);
  const Material* const materials[] = {&phong, &flat};
  for (const Material* material : materials) {
    Vec3f diffuse = material->getDiffuseColor(), transparent = material->getTransparentColor(),
          reflective = material->getReflectiveColor();
    float index = material->getIndexOfRefraction();
    CHECK_EQUAL(diffuse, diffuseColor);
    CHECK_EQUAL(transparent, transparentColor);
    CHECK_EQUAL(reflective, reflectiveColor);
    CHECK_EQUAL(index, 1.5f);
    const Ray ray(Vec3f(0, 5, 0), Vec3f(0, -1, 0));
    const Hit hit(5.0f, material, Vec3f(0, 1, 0));
    const Vec3f dirToLight(0, 1, 0), lightColor(1, 0.5f, 0.5f);
    CHECK_EQUAL(material->Shade(ray, hit, dirToLight, lightColor), Vec3f(0.5f, 0.125f, 0.5f));
  }
  Vec3f specular = phong.getSpecularColor();
  CHECK_EQUAL(specular, specularColor);
  CHECK_EQUAL(phong.getExponent(), 10.0f);
}

TEST("mirrorDirection and transmittedDirection take Vec3f and float") {
  const Vec3f normal(0, 1, 0), incoming(0.6f, -0.8f, 0);
  Vec3f mirrored = mirrorDirection(normal, incoming), transmitted;
  float index_i = 1, index_t = 1;
  bool through = transmittedDirection(normal, incoming, index_i, index_t, transmitted);
  CHECK(through);
  CHECK_EQUAL(mirrored, Vec3f(0.6f, 0.8f, 0));
  CHECK_NEAR_VECTOR(transmitted, incoming, 1e-6);
}

TEST("a RayTracer is made from a scene, bounces and a weight, and traces a ray") {
  SceneParser scene = scene_text::parse(kScene);
  SceneParser* s = &scene;
  int max_bounces = 5;
  float min_weight = 0.01f, tmin = 0, weight = 1, indexOfRefraction = 1;
  RayTracer tracer(s, max_bounces, min_weight);
  Ray ray(Vec3f(0, 0, 5), Vec3f(0, 0, -1));
  Hit hit;
  Vec3f color = tracer.traceRay(ray, tmin, 0, weight, indexOfRefraction, hit);
  // Ambient 0.5 and light 1, straight on.
  CHECK_EQUAL(color, Vec3f(0.75f, 0.375f, 0.1875f));
  Ray past(Vec3f(0, 3, 5), Vec3f(0, 0, -1));
  Hit none;
  CHECK_EQUAL(tracer.traceRay(past, tmin, 0, weight, indexOfRefraction, none),
              Vec3f(0.25f, 0.5f, 0.75f));
}

TEST("objects are made from Vec3f and float, put into groups, and asked their two questions") {
  const PhongMaterial material(Vec3f(1, 1, 1), Vec3f(), 1, Vec3f(), Vec3f(), 1);
  const Sphere sphere(Vec3f(0, 0, 0), 1.0f, &material);
  const Plane plane(Vec3f(0, 0, 1), -2.0f, &material);
  const Triangle triangle(Vec3f(-1, -1, -3), Vec3f(1, -1, -3), Vec3f(0, 1, -3), &material);
  const MeshGeometry geometry({Vec3f(-1, -1, -4), Vec3f(1, -1, -4), Vec3f(0, 1, -4)}, {{0, 1, 2}});
  const TriangleMesh mesh(&geometry, &material);
  const Transform moved(Matrix::translation(Vec3f(0, 0, -6)), &sphere);
  Group group(5);
  const Object3D* const objects[] = {&sphere, &plane, &triangle, &mesh, &moved};
  for (int i = 0; i < 5; ++i) group.addObject(i, objects[i]);
  CHECK_EQUAL(group.getGroupSize(), 5);
  const double expected[] = {4, 7, 8, 9, 10};
  const Ray ray(Vec3f(0, 0, 5), Vec3f(0, 0, -1));
  for (int i = 0; i < 5; ++i) {
    Hit hit;
    const Object3D* object = objects[i];
    float tmin = 0;
    CHECK(object->intersect(ray, hit, tmin));
    CHECK_EQUAL(hit.getT(), expected[i]);
    CHECK_EQUAL(hit.getMaterial(), &material);
    CHECK_EQUAL(hit.getNormal(), Vec3d(0, 0, 1));
    CHECK(object->occluded(ray, tmin, 100.0f));
  }
  Hit nearest;
  CHECK(group.intersect(ray, nearest, 0.0f));
  CHECK_EQUAL(nearest.getT(), 4.0);
  CHECK_EQUAL(nearest.getIntersectionPoint(), Vec3d(0, 0, 1));
  CHECK_EQUAL(ray.pointAtParameter(2.0f), Vec3d(0, 0, 3));
}

TEST("cameras are made from Vec3f and float, and turn points of the image into rays") {
  const OrthographicCamera orthographic(Vec3f(0, 0, 5), Vec3f(0, 0, -1), Vec3f(0, 1, 0), 4.0f);
  const PerspectiveCamera perspective(Vec3f(0, 0, 5), Vec3f(0, 0, -1), Vec3f(0, 1, 0), 0.5f);
  const Camera* const cameras[] = {&orthographic, &perspective};
  for (const Camera* camera : cameras) {
    const Ray ray = camera->generateRay(Vec2f(0, 0));
    CHECK_EQUAL(ray.getOrigin(), Vec3d(0, 0, 5));
    CHECK_EQUAL(ray.getDirection(), Vec3d(0, 0, -1));
    CHECK(camera->getTMin() <= 0);
  }
}

TEST("a SceneParser gives everything that a tracer needs") {
  SceneParser scene = scene_text::parse(kScene);
  CHECK(scene.getCamera() != nullptr);
  CHECK_EQUAL(scene.getBackgroundColor(), Vec3f(0.25f, 0.5f, 0.75f));
  CHECK_EQUAL(scene.getAmbientLight(), Vec3f(0.5f, 0.5f, 0.5f));
  CHECK_EQUAL(scene.getNumLights(), 1);
  CHECK_EQUAL(scene.getNumMaterials(), 1);
  CHECK_EQUAL(scene.getMaterial(0)->getDiffuseColor(), Vec3f(0.5f, 0.25f, 0.125f));
  CHECK(scene.getGroup() != nullptr);
  const Light* light = scene.getLight(0);
  Vec3d dirToLight;
  Vec3f color;
  double distance;
  light->getIllumination(Vec3f(0, 0, 0), dirToLight, color, distance);
  CHECK_EQUAL(dirToLight, Vec3d(0, 0, 1));
  CHECK_EQUAL(color, Vec3f(1, 1, 1));
}

TEST("an Image is filled by pixels of Vec3f") {
  Image image(3, 2);
  image.setAllPixels(Vec3f(0, 0, 0));
  image.setPixel(2, 1, Vec3f(1, 0.5f, 0));
  CHECK_EQUAL(image.Width(), 3);
  CHECK_EQUAL(image.Height(), 2);
  CHECK(image.getPixel(2, 1) == (Rgb8{255, 127, 0}));
  CHECK(image.getPixel(0, 0) == Rgb8());
}
