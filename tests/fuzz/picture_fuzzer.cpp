// Fuzz target: pictures of scenes that are made from the input's bytes, so that nearly all of them
// are good; each byte chooses what comes next, or a number. Demand: the tree, and every instruction
// set, give the bytes that the plain objects give. SHOW_SCENE=1 in the environment prints the
// scene.
#include <iterator>
#include <memory>
#include <sstream>

#include "fuzz.h"
#include "pictures.h"

namespace {

/// Writes a scene, and its mesh, by what the bytes say; when they run out, all choices are 0.
class SceneWriter {
 public:
  SceneWriter(const std::uint8_t* data, std::size_t size) : next_(data), end_(data + size) {}

  unsigned choice(unsigned count) { return next_ == end_ ? 0 : *next_++ % count; }

  std::string scene() {
    std::ostringstream text;
    const bool isPerspective = choice(2) == 0;
    text << (isPerspective ? "PerspectiveCamera" : "OrthographicCamera") << " { center" << vector()
         << " direction" << direction() << " up" << direction()
         << (isPerspective ? " angle 60" : " size" + positive()) << " }\n";
    text << "Lights { numLights 2 PointLight { position" << vector()
         << " color 1 .9 .8 } DirectionalLight { direction" << direction()
         << " color .5 .5 1 } }\nMaterials { numMaterials 3 PhongMaterial { diffuseColor 1 .5 .2 "
            "specularColor 1 1 1 exponent 5 } PhongMaterial { reflectiveColor .9 .9 .9 } "
            "PhongMaterial { transparentColor .7 .8 .9 indexOfRefraction 1.5 } }\n";
    const unsigned count = 1 + choice(kMostObjects);
    text << "Group { numObjects " << count << '\n';
    for (unsigned i = 0; i < count; ++i) writeObject(text, 0);
    text << "}\n";
    return text.str();
  }

  std::string mesh() {
    std::ostringstream text;
    const unsigned vertices = 3 + choice(20), faces = choice(40);
    for (unsigned i = 0; i < vertices; ++i) text << 'v' << vector() << '\n';
    for (unsigned i = 0; i < faces; ++i) {
      text << 'f';
      for (int corner = 0; corner < 3; ++corner) text << ' ' << 1 + choice(vertices);
      text << '\n';
    }
    return text.str();
  }

 private:
  static constexpr unsigned kMostObjects = 24;
  static constexpr int kDeepest = 4;

  /// Half of the bytes are places of a small grid, where surfaces often coincide.
  std::string number() {
    static constexpr const char* kNumbers[] = {"0.1",
                                               "0.30000000000000004",
                                               "0.99999999999999989",
                                               "1.0000000000000002",
                                               "1e-3",
                                               "1e-6",
                                               "-1e-6",
                                               "1e-9",
                                               "1e-15",
                                               "1e-38",
                                               "1e-45",
                                               "1e-150",
                                               "1e-300",
                                               "1e-320",
                                               "1000",
                                               "-1000",
                                               "1e5",
                                               "-1e6",
                                               "1e9",
                                               "16777217",
                                               "1e15",
                                               "-1e17",
                                               "1e25",
                                               "3e38",
                                               "-3e38",
                                               "1e100",
                                               "1e150",
                                               "-1e154",
                                               "1e200",
                                               "-1e300",
                                               "1e308",
                                               "-0"};
    if (choice(16) == 0) return std::string(" ") + kNumbers[choice(std::size(kNumbers))];
    return " " + std::to_string((int(choice(65)) - 32) / 8.0);
  }
  std::string positive() {
    const std::string text = number();
    return text == " 0.000000" || text == " -0" ? " 1"
           : text[1] == '-'                     ? " " + text.substr(2)
                                                : text;
  }
  /// Streamed, not added: the order in which sums are evaluated is the compiler's choice.
  std::string vector() {
    std::ostringstream text;
    text << number() << number() << number();
    return text.str();
  }
  std::string direction() {
    static constexpr const char* kDirections[] = {" 0 0 -1", " 0 1 0", " 1 0 0",   " 0 -1 0",
                                                  " 1 1 -1", " 1 2 3", " -1 .1 .2"};
    const unsigned which = choice(std::size(kDirections) + 1);
    return which < std::size(kDirections) ? kDirections[which] : vector();
  }

  void writeStep(std::ostream& text) {
    switch (choice(6)) {
      case 0:
        text << "Translate" << vector();
        break;
      case 1:
        text << "UniformScale" << positive();
        break;
      case 2:
        text << "Scale" << positive() << positive() << positive();
        break;
      case 3:
        text << "YRotate" << number();
        break;
      case 4:
        text << "Rotate {" << direction() << number() << " }";
        break;
      default:
        text << "Scale -1 1 1";
        break;
    }
  }

  void writeGroup(std::ostream& text, int depth) {
    const unsigned count = choice(4);
    text << "Group { numObjects " << count << ' ';
    for (unsigned i = 0; i < count; ++i) writeObject(text, depth + 1);
    text << '}';
  }

  void writeTransform(std::ostream& text, int depth) {
    text << "Transform { ";
    for (unsigned steps = choice(4); steps > 0; --steps) {
      writeStep(text);
      text << ' ';
    }
    writeShape(text, depth + 1);
    text << " }";
  }

  void writeObject(std::ostream& text, int depth) {
    text << "MaterialIndex " << choice(3) << ' ';
    writeShape(text, depth);
    text << '\n';
  }

  void writeShape(std::ostream& text, int depth) {
    switch (choice(depth < kDeepest ? 6 : 4)) {
      case 0:
        text << "Sphere { center" << vector() << " radius" << positive() << " }";
        break;
      case 1:
        text << "Plane { normal" << direction() << " offset" << number() << " }";
        break;
      case 2:
        text << "Triangle { vertex0" << vector() << " vertex1" << vector() << " vertex2" << vector()
             << " }";
        break;
      case 3:
        text << "TriangleMesh { obj_file m.obj }";
        break;
      case 4:
        writeGroup(text, depth);
        break;
      default:
        writeTransform(text, depth);
        break;
    }
  }

  const std::uint8_t* next_;
  const std::uint8_t* end_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::Scratch scratch;
  SceneWriter writer(data, size);
  const RenderOptions options = fuzz::optionsFrom(writer.choice(256));
  const std::string mesh = writer.mesh(), scene = writer.scene();
  scratch.write("m.obj", mesh);
  const std::string path = scratch.write("scene.txt", scene);
  if (std::getenv("SHOW_SCENE")) std::printf("%s@@\n%s", scene.c_str(), mesh.c_str());
  std::unique_ptr<SceneParser> parsed;
  try {
    parsed = std::make_unique<SceneParser>(path.c_str());
  } catch (const InputError&) {
    return 0;  // a transform that cannot be inverted, an up parallel to the direction
  }
  fuzz::comparePictures(*parsed, options);
  return 0;
}
