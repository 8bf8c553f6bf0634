// Pictures that a scene names: where they are found, each read once, and what is said of those that
// are missing or broken.
#include <filesystem>

#include "image/picture_file.h"
#include "scene/named_files.h"
#include "scene_files.h"
#include "vectors.h"

namespace {

/// A scene's text in a folder of its own, and the pictures that its words name.
class Desk {
 public:
  /// The words stand on lines 2, 3...
  explicit Desk(const std::vector<std::string>& words)
      : folder_(check::temporaryFolder() + "/pictures_" + std::to_string(getpid())),
        text_(folder_ + "/scene.txt", textOf(words)),
        library_(text_, log_, pictures_) {
    std::filesystem::create_directories(folder_ + "/church");
  }
  ~Desk() { std::filesystem::remove_all(folder_); }

  std::string file(const std::string& name) const { return folder_ + "/" + name; }
  /// A picture of one pixel.
  void write(const std::string& name, Rgb8 color) const {
    Image image(1, 1);
    image.setPixel(0, 0, color);
    writePicture(image, file(name));
  }
  void writeFaces(const std::string& ending) const {
    for (std::size_t i = 0; i < 6; ++i) {
      write("church/" + std::string(CubeMap::kFaces[i]) + "." + ending,
            Rgb8{std::uint8_t(51 * i), 0, 255});
    }
  }
  void spoil(const std::string& name) const { std::ofstream(file(name)) << "no picture"; }

  /// The n-th word, as a view of the text.
  std::string_view word(std::size_t n) const {
    Tokenizer words(text_.bytes());
    while (n-- > 0) words.next();
    return words.next();
  }
  const ImageTexture* find(std::size_t n) { return library_.find(word(n)); }
  std::optional<CubeMap> findCube(const char* ending) { return library_.findCube(word(0), ending); }
  PictureLibrary& library() { return library_; }
  std::size_t readCount() const { return pictures_.size(); }
  /// "LINE: message" of each mistake, with the folder left out.
  std::string mistakes() const {
    std::string all;
    for (const InputError& mistake : log_.inOrder()) {
      all += std::string(mistake.what()).substr(text_.name().size() + 1) + "\n";
    }
    for (std::size_t at; (at = all.find(folder_)) != all.npos;) all.erase(at, folder_.size() + 1);
    return all;
  }

 private:
  static std::string textOf(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += "\n" + word;
    return text;
  }

  std::string folder_;
  SourceText text_;
  MistakeLog log_{MistakeLog::Mode::collect};
  std::vector<std::unique_ptr<ImageTexture>> pictures_;
  PictureLibrary library_;
};

const Rgb8 kColor = {51, 102, 255};
const Vec3d kColorOfIt(0.2, 0.4, 1);

}  // namespace

TEST("a picture of any format is found beside the scene") {
  for (const std::string name : {"a.bmp", "a.png", "a.tga", "a.ppm", "a.pfm"}) {
    Desk desk({name});
    desk.write(name, kColor);
    const ImageTexture* const texture = desk.find(0);
    CHECK_EQUAL(desk.mistakes(), "");
    if (texture) CHECK_NEAR_VECTOR(texture->colorAt(0.5, 0.5), kColorOfIt, 1e-15);
    CHECK(texture != nullptr);
  }
}

TEST("a picture is read once, by whatever names the scene calls it") {
  Desk desk({"a.bmp", "church/../a.bmp", "a.bmp", "link.bmp", "church\\..\\a.bmp"});
  desk.write("a.bmp", kColor);
  std::filesystem::create_symlink("a.bmp", desk.file("link.bmp"));
  const ImageTexture* const texture = desk.find(0);
  CHECK(texture != nullptr);
  for (std::size_t n = 1; n < 5; ++n) CHECK_EQUAL(desk.find(n), texture);
  CHECK_EQUAL(desk.readCount(), std::size_t(1));
  // A path for each name, as all of them must stay what they are.
  const std::string path = std::filesystem::canonical(desk.file("a.bmp")).string();
  CHECK(desk.library().files().paths() == std::vector<std::string>(4, path));
}

TEST("a picture that is missing is a mistake where it is named, which is told once") {
  Desk desk({"a.bmp", "b.bmp"});
  desk.write("a.bmp", kColor);
  CHECK(desk.find(0) && !desk.find(1) && !desk.find(1));
  CHECK_EQUAL(desk.mistakes(),
              "3: cannot read the picture 'b.bmp'; looked for 'b.bmp' (No such file or "
              "directory), 'b.bmp' (No such file or directory)\n");
  CHECK_EQUAL(desk.library().files().paths().size(), std::size_t(1));
}

TEST("a picture that is broken is a mistake where it is named, which tells what is wrong") {
  Desk desk({"a.bmp", "church"});
  desk.spoil("a.bmp");
  CHECK(!desk.find(0) && !desk.find(1));
  const std::string mistakes = desk.mistakes();
  CHECK(scenes::contains(mistakes, "2: cannot read the picture 'a.bmp'; a.bmp: expected"));
  CHECK(scenes::contains(mistakes, "3: cannot read the picture 'church'; church: "));
}

TEST("a cube map is six pictures in a folder") {
  for (const std::string folder : {"church", "church/", "church\\", "\"church\""}) {
    Desk desk({folder});
    desk.writeFaces("bmp");
    const auto cube = desk.findCube("bmp");
    CHECK_EQUAL(desk.mistakes(), "");
    if (cube) {
      // left, right, up, down, front, back
      const Vec3d ways[] = {{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
      for (int i = 0; i < 6; ++i)
        CHECK_NEAR_VECTOR(cube->colorAt(ways[i]), Vec3d(0.2 * i, 0, 1), 1e-15);
    }
    CHECK(cube.has_value());
  }
}

TEST("the faces of a cube map have the ending that is asked for, or else another one") {
  Desk desk({"church"});
  desk.writeFaces("png");
  CHECK(desk.findCube("bmp").has_value());
  CHECK_EQUAL(std::filesystem::path(desk.library().files().paths()[0]).filename(), "back.png");
  desk.writeFaces("bmp");
  CHECK(desk.findCube("bmp").has_value());
  CHECK_EQUAL(desk.readCount(), std::size_t(12));
}

TEST("a cube map's first missing face is a mistake where the folder is named") {
  Desk desk({"church"});
  desk.writeFaces("bmp");
  std::filesystem::remove(desk.file("church/down.bmp"));
  std::filesystem::remove(desk.file("church/front.bmp"));
  CHECK(!desk.findCube("png").has_value());
  const std::string mistakes = desk.mistakes();
  CHECK(scenes::contains(mistakes, "2: cannot read the picture 'church/down.png'; looked for"));
  CHECK(!scenes::contains(mistakes, "front"));
}
