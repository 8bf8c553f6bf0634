// Whole pictures of scenes with textures, noise and a cube map: the same bytes by every way of
// tracing, and what else of a run depends on the files.
#include <filesystem>

#include "check.h"
#include "cli/desk.h"
#include "image/picture_file.h"

using check::contains;

namespace {

/// A small picture without two equal pixels.
Image pattern(int width, int height, int seed) {
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image.setPixel(x, y,
                     Rgb8{std::uint8_t(40 * x + seed), std::uint8_t(255 - 50 * y),
                          std::uint8_t((90 * x + 70 * y + 30 * seed) % 256)});
    }
  }
  return image;
}

/// A mesh with a texture, noise on a moved ball of glass and on a floor that mirrors, a church of
/// small pictures.
struct MapDesk : check::Desk {
  MapDesk() {
    std::filesystem::create_directory(file("church"));
    int seed = 0;
    for (const char* face : {"left", "right", "up", "down", "front", "back"}) {
      writePicture(pattern(3 + seed, 4, seed), file("church/" + std::string(face) + ".bmp"));
      ++seed;
    }
    writePicture(pattern(5, 4, 3), file("wall.bmp"));
    write("wall.obj",
          "v -2 -1 -1\nv 2 -1 -1\nv 2 2 -1.5\nv -2 2 -1.5\n"
          "vt -.25 0\nvt 1.25 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n");
    write("scene.txt", R"(
PerspectiveCamera { center 0 0.5 5 direction 0 0 -1 up 0 1 0 angle 50 }
Lights { numLights 2 DirectionalLight { direction -1 -1 -1 color .8 .7 .9 }
  PointLight { position 2 3 4 color 1 .8 .6 falloff .02 } }
Background { color 0.2 0.2 0.2 ambientLight 0.3 0.2 0.1 cubeMap church }
Materials { numMaterials 3
  PhongMaterial { diffuseColor 0 1 0 texture wall.bmp specularColor .2 .3 .2 shininess 9 }
  PhongMaterial { specularColor .5 .4 .6 refractionIndex 1.4
    Noise { color 1 0 .3 color 0 .4 .9 octaves 3 frequency 4 amplitude 5 } }
  PhongMaterial { specularColor .6 .6 .5 shininess 30
    Noise { color .9 .8 .1 color .1 .2 .3 octaves 2 frequency 2 amplitude 3 } } }
Group { numObjects 3
  MaterialIndex 0 TriangleMesh { obj_file wall.obj }
  MaterialIndex 1 Transform { Translate 0 .3 1 Scale .9 .6 .5 Sphere { center 0 0 0 radius 1 } }
  MaterialIndex 2 Plane { normal 0 1 0 offset -1 } }
)");
  }

  /// The bytes of the picture, which every way has to give.
  Bytes picture(const std::string& arguments) const {
    const check::ProgramRun run =
        this->run("-course 2012 -input scene.txt -size 40 40 -output out.ppm " + arguments);
    CHECK_EQUAL(run.status, 0);
    return readBytes(file("out.ppm"));
  }
};

}  // namespace

TEST("textures, noise and cube maps give the same bytes by every way of tracing") {
  const MapDesk desk;
  std::vector<Bytes> seen;
  for (const std::string kind : {"-bounces 0", "-bounces 4 -shadows", "-jittered_samples 4"}) {
    const Bytes expected = desk.picture(kind + " -accel tree");
    for (const std::string way :
         {"-simd baseline", "-simd avx2 -threads 2", "-simd avx512", "-grid 4 4 4"}) {
      CHECK(desk.picture(kind + " " + way) == expected);
    }
    CHECK(std::find(seen.begin(), seen.end(), expected) == seen.end());
    seen.push_back(expected);
  }
}

TEST("a texture, noise and a cube map change the picture, each on its own") {
  const MapDesk desk;
  const Bytes whole = desk.picture("-bounces 1");
  std::ifstream in(desk.file("scene.txt"));
  const std::string scene((std::istreambuf_iterator<char>(in)), {});
  for (const std::string words :
       {"texture wall.bmp", "cubeMap church",
        "Noise { color 1 0 .3 color 0 .4 .9 octaves 3 frequency 4 amplitude 5 }"}) {
    std::string changed = scene;
    desk.write("scene.txt", changed.replace(changed.find(words), words.size(), ""));
    CHECK(desk.picture("-bounces 1") != whole);
  }
}

TEST("-stats tells the memory of pictures, where there are any") {
  const MapDesk desk;
  const std::string arguments = "-course 2012 -size 3 3 -stats -input ";
  // 5 x 4 pixels of the wall and (3 + 4 + 5 + 6 + 7 + 8) x 4 of the church, three bytes each.
  CHECK(contains(desk.run(arguments + "scene.txt").output, "\nbytes of pictures: 456\n"));
  desk.write("plain.txt", check::smallScene());
  CHECK(!contains(desk.run(arguments + "plain.txt").output, "bytes of pictures"));
}

TEST("a picture of the scene is not replaced by an output, and counts in a part's fingerprint") {
  const MapDesk desk;
  const std::string start = "-course 2012 -input scene.txt -size 8 8 ";
  const check::ProgramRun refused = desk.run(start + "-output church/up.bmp");
  CHECK_EQUAL(refused.status, 2);
  CHECK(contains(refused.errors, "one of its meshes or pictures"));
  CHECK_EQUAL(desk.run(start + "-tile 1 2 -output a.tga").status, 0);
  writePicture(pattern(5, 4, 8), desk.file("wall.bmp"));
  CHECK_EQUAL(desk.run(start + "-tile 2 2 -output b.tga").status, 0);
  const check::ProgramRun merged = desk.run("-merge whole.tga a.tga b.tga");
  CHECK(merged.status != 0);
  CHECK(contains(merged.errors, "another scene, other meshes"));
}
