// RayTracer: every term of the colour sum in closed form.
#include "render/ray_tracer.h"

#include "scene_text.h"
#include "vectors.h"

using scene_text::bouncing;
using scene_text::colorTowards;
using scene_text::parse;

namespace {

/// A light that travels straight down, and the ground y = 0 of a material given by its fields.
std::string groundUnderSun(const std::string& material, const std::string& more = "") {
  return "Lights { numLights 1 DirectionalLight { direction 0 -1 0 color 1 0.5 0.25 } }"
         "Background { color 0.2 0.4 0.6 ambientLight 0 0 0 }"
         "Materials { numMaterials 2 PhongMaterial {" +
         material +
         "}"
         "  PhongMaterial { diffuseColor 0 0 0 } }"
         "Group { numObjects " +
         (more.empty() ? "1" : "2") + "  MaterialIndex 0 Plane { normal 0 1 0 offset 0 } " + more +
         "}";
}

const Vec3d kAbove(0, 5, 0), kGround(0, 0, 0);
const Vec3f kBackground(0.2f, 0.4f, 0.6f);

/// Two mirrors face each other at z = 0 and z = 3; each shines with 0.5 by itself.
std::string facingMirrors(const std::string& reflectiveColor) {
  return "Lights { numLights 1 DirectionalLight { direction 0 0 1 color 0 0 0 } }"
         "Background { color 0 0 0 ambientLight 0.5 0.5 0.5 }"
         "Materials { numMaterials 1 PhongMaterial { diffuseColor 1 1 1 reflectiveColor " +
         reflectiveColor +
         " } }"
         "Group { numObjects 2 MaterialIndex 0 Plane { normal 0 0 1 offset 0 }"
         "  Plane { normal 0 0 -1 offset -3 } }";
}

Vec3f betweenMirrors(const std::string& reflectiveColor, int bounces, float minWeight) {
  const SceneParser scene = parse(facingMirrors(reflectiveColor));
  RenderOptions options = bouncing(bounces);
  options.minWeight = minWeight;
  return colorTowards(scene, {0, 0, 1}, {0, 0.1, 0}, options);
}

}  // namespace

TEST("a ray that misses everything has the background's colour") {
  const SceneParser scene = parse(groundUnderSun(""));
  CHECK_EQUAL(colorTowards(scene, kAbove, {0, 9, 0}), kBackground);
}

TEST("ambient light is filtered by the diffuse colour") {
  const SceneParser scene = parse(
      "Lights { numLights 1 DirectionalLight { direction 0 0 1 color 1 1 1 } }"
      "Background { color 0 0 0 ambientLight 0.5 0.25 1 }"
      "Materials { numMaterials 1 PhongMaterial { diffuseColor 0.5 1 0.25 } }"
      "Group { numObjects 1 MaterialIndex 0 Sphere { center 0 0 0 radius 1 } }");
  // The light comes from behind: n.l = -1 at the front.
  CHECK_EQUAL(colorTowards(scene, {0, 0, 5}, {0, 0, 0}), Vec3f(0.25f, 0.25f, 0.25f));
}

TEST("without any lights the ambient light is white") {
  const SceneParser scene = parse(
      "Background { color 0 0 0 ambientLight 0.5 0.5 0.5 }"
      "Materials { numMaterials 1 PhongMaterial { diffuseColor 0.5 1 0.25 } }"
      "Group { numObjects 1 MaterialIndex 0 Sphere { center 0 0 0 radius 1 } }");
  CHECK_EQUAL(colorTowards(scene, {0, 0, 5}, {0, 0, 0}), Vec3f(0.5f, 1, 0.25f));
}

TEST("a directional light gives its colour times the cosine times the diffuse colour") {
  const SceneParser scene = parse(
      "Lights { numLights 1 DirectionalLight { direction -4 -3 0 color 1 0.5 0.25 } }"
      "Materials { numMaterials 1 PhongMaterial { diffuseColor 0.5 0.5 1 } }"
      "Group { numObjects 1 MaterialIndex 0 Plane { normal 0 1 0 offset 0 } }");
  // n.l = 3/5.
  CHECK_NEAR_VECTOR(colorTowards(scene, kAbove, kGround), Vec3d(0.3, 0.15, 0.15), 1e-7);
}

TEST("a point light is dimmed with its distance and slant") {
  const SceneParser scene = parse(
      "Lights { numLights 1 PointLight { position 3 4 0 color 1 1 1 attenuation 1 0.2 0.08 } }"
      "Materials { numMaterials 1 PhongMaterial { diffuseColor 1 0.5 0.25 } }"
      "Group { numObjects 1 MaterialIndex 0 Plane { normal 0 1 0 offset 0 } }");
  // s = 5, n.l = 0.8, L = 1 / (1 + 1 + 2) = 0.25: 0.2 times the diffuse colour.
  CHECK_NEAR_VECTOR(colorTowards(scene, {0, 1, 0}, kGround), Vec3d(0.2, 0.1, 0.05), 1e-7);
}

TEST("the lights add up") {
  const SceneParser scene = parse(
      "Lights { numLights 3 DirectionalLight { direction 0 -1 0 color 0.5 0 0 }"
      "  PointLight { position 0 2 0 color 0 0.25 0 }"
      "  DirectionalLight { direction 0 1 0 color 9 9 9 } }"  // from below: adds nothing
      "Background { ambientLight 0 0 0.125 }"
      "Materials { numMaterials 1 PhongMaterial { } }"
      "Group { numObjects 1 MaterialIndex 0 Plane { normal 0 1 0 offset 0 } }");
  CHECK_EQUAL(colorTowards(scene, {1, 1, 0}, kGround), Vec3f(0.5f, 0.25f, 0.125f));
}

TEST("the highlight stands around the mirrored ray") {
  const std::string material = "diffuseColor 0 0 0 specularColor 1 1 0.5 exponent 2";
  const SceneParser scene = parse(groundUnderSun(material));
  // From (3, 4): r = (-0.6, 0.8), r.l = 0.8, squared 0.64; times the light 1, 0.5, 0.25.
  CHECK_NEAR_VECTOR(colorTowards(scene, {3, 4, 0}, kGround), Vec3d(0.64, 0.32, 0.08), 1e-6);
}

TEST("with exponent 0 the highlight has full strength, but not behind the mirrored ray") {
  const SceneParser scene = parse(
      "Lights { numLights 1 DirectionalLight { direction -24 -7 0 color 1 1 1 } }"
      "Materials { numMaterials 1"
      "  PhongMaterial { diffuseColor 0 0 0 specularColor 1 0.5 0.25 exponent 0 } }"
      "Group { numObjects 1 MaterialIndex 0 Plane { normal 0 1 0 offset 0 } }");
  // l = (0.96, 0.28). From (-3, 4): r = (0.6, 0.8), r.l = 0.8; from (3, 4): r.l = -0.352.
  CHECK_EQUAL(colorTowards(scene, {-3, 4, 0}, kGround), Vec3f(1, 0.5f, 0.25f));
  CHECK_EQUAL(colorTowards(scene, {3, 4, 0}, kGround), Vec3f());
}

TEST("what stands in the way of a light casts a shadow, unless shadows are off") {
  const SceneParser scene =
      parse(groundUnderSun("", "MaterialIndex 1 Sphere { center 0 50 0 radius 1 }"));
  CHECK_EQUAL(colorTowards(scene, {3, 4, 0}, kGround), Vec3f());
  CHECK_EQUAL(colorTowards(scene, {3, 4, 0}, {2, 0, 0}), Vec3f(1, 0.5f, 0.25f));
  RenderOptions options;
  options.shadows = false;
  CHECK_EQUAL(colorTowards(scene, {3, 4, 0}, kGround, options), Vec3f(1, 0.5f, 0.25f));
}

TEST("only what lies before a point light casts its shadow") {
  const auto at = [](double height) {
    return parse(
        "Lights { numLights 1 PointLight { position 0 5 0 color 1 1 1 } }"
        "Materials { numMaterials 1 PhongMaterial { } }"
        "Group { numObjects 2 MaterialIndex 0 Plane { normal 0 1 0 offset 0 }"
        "  Sphere { center 0 " +
        scene_text::word(height) + " 0 radius 0.5 } }");
  };
  CHECK_EQUAL(colorTowards(at(3), {3, 1, 0}, kGround), Vec3f());
  CHECK_EQUAL(colorTowards(at(5.2), {3, 1, 0}, kGround), Vec3f());  // the light is inside
  CHECK_EQUAL(colorTowards(at(6), {3, 1, 0}, kGround), Vec3f(1, 1, 1));
  CHECK_EQUAL(colorTowards(at(-1), {3, 1, 0}, kGround), Vec3f(1, 1, 1));
}

TEST("a shadow ray looks from epsilon on") {
  // Tiny balls whose underside lies at t = 0.002 and whose top ends at t = 0.0009.
  const auto ball = [](double center, double radius) {
    return parse(groundUnderSun("", "MaterialIndex 1 Sphere { center 0 " +
                                        scene_text::word(center) + " 0 radius " +
                                        scene_text::word(radius) + " }"));
  };
  RenderOptions options;
  options.epsilon = {Epsilon::Kind::fixed, 0.001};
  CHECK_EQUAL(colorTowards(ball(0.0025, 0.0005), {3, 4, 0}, kGround, options), Vec3f());
  CHECK_EQUAL(colorTowards(ball(0.0006, 0.0003), {3, 4, 0}, kGround, options),
              Vec3f(1, 0.5f, 0.25f));
}

TEST("a mirror adds its colour times what it shows, here the background") {
  const SceneParser scene = parse(groundUnderSun("diffuseColor 0 0 0 reflectiveColor 0.5 1 0.25"));
  CHECK_NEAR_VECTOR(colorTowards(scene, {3, 4, 0}, kGround), Vec3d(0.1, 0.4, 0.15), 1e-7);
  CHECK_EQUAL(colorTowards(scene, {3, 4, 0}, kGround, bouncing(0)), Vec3f());
}

TEST("a mirror shows what lies in the mirrored direction") {
  // From (-3, 4) over (0, 0) the ray goes on along (0.6, 0.8) to (6, 8), and meets a small ball.
  const SceneParser scene = parse(
      "Lights { numLights 1 DirectionalLight { direction 0 1 0 color 0 0 0 } }"
      "Background { color 0 0 0 ambientLight 1 1 1 }"
      "Materials { numMaterials 2"
      "  PhongMaterial { diffuseColor 0.125 0 0 reflectiveColor 0.5 0.5 0.5 }"
      "  PhongMaterial { diffuseColor 0.5 0.25 1 } }"
      "Group { numObjects 2 MaterialIndex 0 Plane { normal 0 1 0 offset 0 }"
      "  MaterialIndex 1 Sphere { center 6 8 0 radius 0.001 } }");
  CHECK_EQUAL(colorTowards(scene, {-3, 4, 0}, kGround), Vec3f(0.375f, 0.125f, 0.5f));
}

TEST("the number of bounces ends a row of mirrors") {
  // Each surface adds 0.5, the mirror halves: 0.5 (1 + 1/2 + ... + 1/2^N) = 1 - 1/2^(N + 1).
  for (int bounces = 0; bounces <= 6; ++bounces) {
    const float expected = 1 - 1 / float(2 << bounces);
    CHECK_EQUAL(betweenMirrors("0.5 0.5 0.5", bounces, 0), Vec3f(expected, expected, expected));
  }
}

TEST("a mirror ray is traced as long as its weight is not below the least") {
  // |(0.5, 0, 0)| = 0.5: the weights are 0.5, 0.25, 0.125, ...
  CHECK_EQUAL(betweenMirrors("0.5 0 0", 9, 0.51f).r(), 0.5f);
  CHECK_EQUAL(betweenMirrors("0.5 0 0", 9, 0.5f).r(), 0.75f);
  CHECK_EQUAL(betweenMirrors("0.5 0 0", 9, 0.26f).r(), 0.75f);
  CHECK_EQUAL(betweenMirrors("0.5 0 0", 9, 0.25f).r(), 0.875f);
  CHECK_EQUAL(betweenMirrors("0.5 0 0", 9, 0.125f).r(), 0.9375f);
}

TEST("refracted rays stop by weight as mirror rays do") {
  // Three sheets of air, each shining with 0.5 and letting half of the red through.
  const SceneParser scene = parse(
      "Background { color 0 0 0 ambientLight 0 0 0 } Materials { numMaterials 1"
      "  PhongMaterial { diffuseColor 0.5 0 0 transparentColor 0.5 0 0 } }"
      "Group { numObjects 3 MaterialIndex 0 Plane { normal 0 0 1 offset 0 }"
      "  Plane { normal 0 0 1 offset -1 } Plane { normal 0 0 1 offset -2 } }");
  const float weights[4] = {0.51f, 0.5f, 0.26f, 0.25f};
  const float expected[4] = {0.5f, 0.75f, 0.75f, 0.875f};
  for (int i = 0; i < 4; ++i) {
    RenderOptions options = bouncing(9);
    options.minWeight = weights[i];
    CHECK_EQUAL(colorTowards(scene, {0, 0, 1}, {0, 0, 0}, options).r(), expected[i]);
  }
}

TEST("the weight is the length of the colour, so a white mirror never fades") {
  // |(0.3, 0.4, 0)| = 0.5.
  CHECK_NEAR(betweenMirrors("0.3 0.4 0", 1, 0.499f).r(), 0.65, 1e-7);
  CHECK_EQUAL(betweenMirrors("0.3 0.4 0", 1, 0.501f).r(), 0.5f);
  CHECK_EQUAL(betweenMirrors("1 1 1", 7, 1), Vec3f(4, 4, 4));  // 8 times 0.5
}

TEST("index 1 lets the ray go straight through, filtered by the transparent colour") {
  const SceneParser scene =
      parse(groundUnderSun("diffuseColor 0 0 0 transparentColor 0.5 0.25 1 indexOfRefraction 1"));
  CHECK_NEAR_VECTOR(colorTowards(scene, {3, 4, 0}, kGround), Vec3d(0.1, 0.1, 0.6), 1e-7);
  CHECK_EQUAL(colorTowards(scene, {3, 4, 0}, kGround, bouncing(0)), Vec3f());
}

TEST("a glass slab shifts the ray sideways by Snell's law") {
  // From (-0.8, 0.6) to (0, 0): sine 0.8, in glass of index 2 sine 0.4, cosine sqrt(0.84). A slab
  // sqrt(0.84) thick is left at x = 0.4, and 0.6 below it the ray has reached x = 1.2.
  const double thickness = std::sqrt(0.84);
  const auto scene = [&](double x) {
    return parse(
        "Lights { numLights 1 DirectionalLight { direction 0 1 0 color 0 0 0 } }"
        "Background { color 0 0 0 ambientLight 1 1 1 }"
        "Materials { numMaterials 2 PhongMaterial { diffuseColor 0 0 0"
        "  transparentColor 0.5 0.5 0.5 indexOfRefraction 2 } PhongMaterial { } }"
        "Group { numObjects 3 MaterialIndex 0 Plane { normal 0 1 0 offset 0 }"
        "  Plane { normal 0 -1 0 offset" +
        scene_text::word(thickness) +
        "}"
        "  MaterialIndex 1 Sphere { center" +
        scene_text::word(Vec3d(x, -thickness - 0.6, 0)) + "  radius 0.00001 } }");
  };
  const Vec3f quarter(0.25f, 0.25f, 0.25f);  // 0.5 at either side of the slab
  CHECK_EQUAL(colorTowards(scene(1.2), {-0.8, 0.6, 0}, kGround), quarter);
  CHECK_EQUAL(colorTowards(scene(1.2001), {-0.8, 0.6, 0}, kGround), Vec3f());
  CHECK_EQUAL(colorTowards(scene(1.2), {-0.8, 0.6, 0}, kGround, bouncing(1)), Vec3f());
}

TEST("total internal reflection adds nothing") {
  const SceneParser scene =
      parse(groundUnderSun("diffuseColor 0 0 0 transparentColor 1 1 1 indexOfRefraction 2"));
  // From below is from inside: beyond sine 0.5 nothing comes through.
  CHECK_EQUAL(colorTowards(scene, {-0.6, -0.8, 0}, kGround), Vec3f());
  CHECK_NEAR_VECTOR(colorTowards(scene, {-0.28, -0.96, 0}, kGround), kBackground, 1e-7);
}

TEST("the side of the normal says whether a ray goes in or out") {
  // From below, sine 0.28 in glass of index 2 leaves with sine 0.56 and meets the ball there.
  const double sine = 0.56, cosine = std::sqrt(1 - sine * sine);
  const SceneParser scene = parse(
      groundUnderSun("diffuseColor 0 0 0 transparentColor 1 1 1 indexOfRefraction 2",
                     "MaterialIndex 1 Sphere { center" +
                         scene_text::word(Vec3d(sine, cosine, 0) * 3.0) + "radius 0.00001 }"));
  CHECK_EQUAL(colorTowards(scene, {-0.28, -0.96, 0}, kGround), Vec3f());  // the ball is black
}

TEST("reflection and refraction add to ambient and light") {
  const SceneParser scene = parse(
      groundUnderSun("diffuseColor 0.5 0.5 0.5 reflectiveColor 0.25 0 0 transparentColor 0 0.5 0"));
  // Light 0.5 (1, 0.5, 0.25) straight from above; mirror 0.25 x 0.2; through 0.5 x 0.4.
  CHECK_NEAR_VECTOR(colorTowards(scene, {3, 4, 0}, kGround), Vec3d(0.55, 0.45, 0.125), 1e-7);
}

TEST("a negative colour neither mirrors nor lets through") {
  // The scene file may hold them; only a component above 0 makes a secondary ray.
  const SceneParser scene =
      parse(groundUnderSun("diffuseColor 0 0 0 reflectiveColor -1 0 0 transparentColor -1 -1 -1"));
  CHECK_EQUAL(colorTowards(scene, {3, 4, 0}, kGround), Vec3f());
}

TEST("shading the back lights a surface from the viewer's side, in the sum over lights alone") {
  const SceneParser scene = parse(
      "Lights { numLights 1 DirectionalLight { direction 0 -1 0 color 1 0.5 0.25 } }"
      "Background { color 0.5 0.5 0.5 }"
      "Materials { numMaterials 1 PhongMaterial { diffuseColor 0.5 0.5 0.5"
      "  transparentColor 0.25 0.25 0.25 indexOfRefraction 2 } }"
      "Group { numObjects 1 MaterialIndex 0 Plane { normal 0 -1 0 offset 0 } }");
  RenderOptions back;
  back.shadeBack = true;
  // The plane faces down. Seen from above (its back) it is lit only with -shade_back; the ray goes
  // out of it at sine 0.28, below the critical 0.5, either way: 0.25 x 0.5 = 0.125.
  const Vec3d eye(0.28, 0.96, 0), below(0, -5, 0);
  CHECK_NEAR_VECTOR(colorTowards(scene, eye, kGround), Vec3d(0.125, 0.125, 0.125), 1e-7);
  CHECK_NEAR_VECTOR(colorTowards(scene, eye, kGround, back), Vec3d(0.625, 0.375, 0.25), 1e-7);
  // At sine 0.6 total reflection: the flipped normal must not let the ray in instead.
  CHECK_NEAR_VECTOR(colorTowards(scene, {0.6, 0.8, 0}, kGround, back), Vec3d(0.5, 0.25, 0.125),
                    1e-7);
  // Seen from below nothing is flipped, and the light is behind.
  CHECK_NEAR_VECTOR(colorTowards(scene, below, kGround, back), Vec3d(0.125, 0.125, 0.125), 1e-7);
}

TEST("a dark back sends back no light and no ambient light, but mirrors and lets through") {
  // Seen from below the ground's front is lit: 1 0.5 0.25 times 0.5, and 0.1 times it.
  const std::string scene =
      "Lights { numLights 1 DirectionalLight { direction 0 -1 0 color 1 0.5 0.25 } }"
      "Background { color 0.2 0.4 0.6 ambientLight 0.1 0.1 0.1 }"
      "Materials { numMaterials 1 PhongMaterial { diffuseColor 0.5 0.5 0.5"
      "  reflectiveColor 0.5 0 0 transparentColor 0 0 0.5 } }"
      "Group { numObjects 1 MaterialIndex 0 Plane { normal 0 1 0 offset 0 } }";
  const SceneParser ground = parse(scene);
  const Vec3f continued(0.1f, 0, 0.3f), local(0.55f, 0.3f, 0.175f);
  RenderOptions options = bouncing(1);
  const Vec3d below(0, -5, 0);
  CHECK_NEAR_VECTOR(colorTowards(ground, below, kGround, options), continued + local, 1e-6);
  options.backs = RenderOptions::Backs::nothing;
  CHECK_NEAR_VECTOR(colorTowards(ground, below, kGround, options), continued, 1e-6);
  CHECK_NEAR_VECTOR(colorTowards(ground, kAbove, kGround, options), continued + local, 1e-6);
  // With shadeBack the side that is seen is lit, here by nothing but ambient light.
  options.shadeBack = true;
  CHECK_NEAR_VECTOR(colorTowards(ground, below, kGround, options),
                    continued + Vec3f(0.05f, 0.05f, 0.05f), 1e-6);
}

TEST("traceRay hands back what it hit, and respects tmin") {
  SceneParser scene = parse(groundUnderSun("", "MaterialIndex 1 Sphere { center 0 3 0 radius 1 }"));
  const RayTracer tracer(&scene, 5, 0.01f);
  Ray ray(kAbove, {0, -1, 0});
  Hit first, last;
  tracer.traceRay(ray, 0, 0, 1, 1, first);
  CHECK_EQUAL(first.getT(), 1.0);
  CHECK_EQUAL(first.getMaterial(), scene.getMaterial(1));
  const Vec3f color = tracer.traceRay(ray, 3.5f, 0, 1, 1, last);
  CHECK_EQUAL(last.getT(), 5.0);
  CHECK_EQUAL(color, Vec3f());  // in the ball's shadow
}

TEST("the assignment's constructor traces the scene's own group with shadows on") {
  SceneParser scene = parse(facingMirrors("0.5 0.5 0.5"));
  Ray ray({0, 0, 1}, {0, 0, -1});
  for (int bounces : {0, 1, 3}) {
    Hit hit;
    const float expected = 1 - 1 / float(2 << bounces);
    CHECK_EQUAL(RayTracer(&scene, bounces, 0.01f).traceRay(ray, 0, 0, 1, 1, hit).r(), expected);
  }
  // |(0.5, 0.5, 0.5)| = sqrt(0.75): its 9th power is 0.274, its 10th 0.237. 9 bounces: 1 - 1/1024.
  Hit light;
  CHECK_EQUAL(RayTracer(&scene, 20, 0.25f).traceRay(ray, 0, 0, 1, 1, light).r(), 1 - 1 / 1024.0f);
  SceneParser shaded = parse(groundUnderSun("", "Sphere { center 0 50 0 radius 1 }"));
  Hit ground;
  Ray down({0, 5, 0}, {0, -1, 0});
  CHECK_EQUAL(RayTracer(&shaded, 5, 0.01f).traceRay(down, 0, 0, 1, 1, ground), Vec3f());
}

TEST("a ray that starts with bounces used up or little weight ends sooner") {
  const SceneParser scene = parse(facingMirrors("0.5 0 0"));
  RenderOptions options = bouncing(3);
  options.minWeight = 0.125f;
  const RayTracer tracer(scene, *scene.getGroup(), options);
  Ray ray({0, 0, 1}, {0, 0, -1});
  Hit a, b, c;
  CHECK_EQUAL(tracer.traceRay(ray, 0, 2, 1, 1, a).r(), 0.75f);
  CHECK_EQUAL(tracer.traceRay(ray, 0, 3, 1, 1, b).r(), 0.5f);
  CHECK_EQUAL(tracer.traceRay(ray, 0, 0, 0.25f, 1, c).r(), 0.75f);
}

TEST("blended glass refracts by the index that the ray carries, and sends 1 - R of what it sees") {
  const SceneParser scene = parse(
      "Background { color 0 0 0 ambientLight 1 1 1 }"
      "Materials { numMaterials 2 Material { diffuseColor 0 0 0 transparentColor 1 1 1"
      "  indexOfRefraction 2 } Material { diffuseColor 1 0 0 } }"
      "Group { numObjects 2 MaterialIndex 0 Plane { normal 0 1 0 offset 0 }"
      "  MaterialIndex 1 Sphere { center 3 -3 0 radius 0.5 } }");
  RenderOptions options = bouncing(1);
  options.blendsGlass = true;
  const RayTracer tracer(scene, *scene.getGroup(), options);
  const auto redOf = [&](float index) {
    Ray ray({-3, 3, 0}, normalize(Vec3d(1, -1, 0)));
    Hit hit;
    return double(tracer.traceRay(ray, 0, 0, 1, index, hit).r());
  };
  // From index 2 into 2 it goes straight on, to the ball. R0 = (1 / 3)^2 and c = cos 45 degrees.
  const double rise = std::pow(1 - std::sqrt(0.5), 5);
  CHECK_NEAR(redOf(2), 1 - (1 / 9.0 + 8 / 9.0 * rise), 1e-6);
  // From index 1 it is bent away from the ball.
  CHECK_NEAR(redOf(1), 0, 0);
}
