// Our files as other programs read them: pngcheck, ImageMagick, Pillow, OpenImageIO, Netpbm. Each
// test is skipped where its program is not installed.
#include <sys/wait.h>

#include <cstdlib>

#include "check.h"
#include "image/picture_file.h"
#include "run_program.h"

namespace {

using check::quoted;

/// Standard output of a shell command, and both its streams where it fails.
struct Finished {
  int status;
  std::string text;
};
Finished shell(const std::string& command) {
  const check::ScratchFolder scratch;
  const std::string file = scratch.file("out");
  const int result = std::system(("{ " + command + "; } >" + quoted(file) + " 2>&1").c_str());
  return {WIFEXITED(result) ? WEXITSTATUS(result) : 255, check::contentOf(file)};
}

void need(const std::string& probe, const std::string& name) {
  if (shell(probe).status != 0) SKIP(name + " is not installed");
}

/// A slope with a red pixel at the top left, 33 x 21 pixels, in every format.
struct Pictures : check::ScratchFolder {
  Pictures() {
    Image image(33, 21);
    for (int y = 0; y < 21; ++y) {
      for (int x = 0; x < 33; ++x) {
        image.setPixel(x, y, Rgb8{std::uint8_t(x * 7), std::uint8_t(y * 12), std::uint8_t(x ^ y)});
      }
    }
    image.setPixel(0, 20, Rgb8{255, 0, 0});
    for (const char* name : {"a.tga", "a.png", "a.ppm", "a.pfm"}) writePicture(image, file(name));
  }
};

/// A picture of few colours, 33 x 21 pixels, of which a PNG has a palette.
struct FewColors : check::ScratchFolder {
  explicit FewColors(bool isGrey) {
    Image image(33, 21);
    for (int y = 0; y < 21; ++y) {
      for (int x = 0; x < 33; ++x) {
        const auto level = std::uint8_t(x * y % 8 * 30);
        image.setPixel(x, y, Rgb8{level, level, isGrey ? level : std::uint8_t(77)});
      }
    }
    for (const char* name : {"a.tga", "a.png", "a.ppm"}) writePicture(image, file(name));
  }
};

/// The command succeeds, and its output is `expected` but for white space at the end.
void checkOutput(const std::string& command, const std::string& expected) {
  Finished run = shell(command);
  while (!run.text.empty() && run.text.back() <= ' ') run.text.pop_back();
  check::report(run.status == 0 && run.text == expected, __FILE__, __LINE__,
                command + ": status " + std::to_string(run.status) + ", '" + run.text +
                    "', expected '" + expected + "'");
}

}  // namespace

TEST("pngcheck finds nothing wrong") {
  need("command -v pngcheck", "pngcheck");
  const Pictures pictures;
  checkOutput("pngcheck -q " + quoted(pictures.file("a.png")), "");
}

TEST("ImageMagick reads every format alike") {
  std::string convert;
  for (const char* name : {"convert", "/usr/bin/convert", "magick"}) {
    if (shell(std::string(name) + " -version | grep ImageMagick").status == 0) convert = name;
  }
  if (convert.empty()) SKIP("ImageMagick is not installed");
  const Pictures pictures;
  const auto pixels = [&](const std::string& name) {
    return convert + " " + quoted(pictures.file(name)) + " -depth 8 rgb:- | cksum";
  };
  const std::string expected =
      shell("tail -c 2079 " + quoted(pictures.file("a.ppm")) + " | cksum").text;
  for (const char* name : {"a.tga", "a.png", "a.ppm", "a.pfm"}) {
    checkOutput(pixels(name), expected.substr(0, expected.size() - 1));
  }
}

TEST("Pillow reads every format alike") {
  const std::string python =
      shell("/usr/bin/python3 -c 'import PIL'").status == 0 ? "/usr/bin/python3" : "python3";
  need(python + " -c 'import PIL'", "Pillow");
  const Pictures pictures;
  for (const char* name : {"a.tga", "a.png"}) {
    checkOutput(python + " -c " +
                    quoted("import sys; from PIL import Image; a, b = (Image.open(f) for f in "
                           "sys.argv[1:]); print(a.mode, a.size, a.tobytes() == b.tobytes(), "
                           "a.getpixel((0, 0)))") +
                    " " + quoted(pictures.file(name)) + " " + quoted(pictures.file("a.ppm")),
                "RGB (33, 21) True (255, 0, 0)");
  }
}

TEST("OpenImageIO reads every format alike") {
  need("command -v oiiotool", "OpenImageIO");
  const Pictures pictures;
  // Of the PFM as of the others: it holds bytes over 255.
  for (const char* name : {"a.tga", "a.png", "a.pfm"}) {
    const Finished run = shell("oiiotool --fail 0.0001 --diff " + quoted(pictures.file("a.ppm")) +
                               " " + quoted(pictures.file(name)));
    check::report(run.status == 0 && run.text.find("PASS") != std::string::npos, __FILE__, __LINE__,
                  std::string(name) + ": " + run.text);
  }
}

TEST("Netpbm reads PNG, PPM and PFM alike") {
  need("command -v pngtopam && command -v pfmtopam", "Netpbm");
  const Pictures pictures;
  const std::string ppm = quoted(pictures.file("a.ppm"));
  checkOutput("pngtopam " + quoted(pictures.file("a.png")) + " | cmp - " + ppm, "");
  checkOutput(
      "pfmtopam -maxval=255 " + quoted(pictures.file("a.pfm")) + " | pamtopnm | cmp - " + ppm, "");
}

TEST("the readers take a PNG with a palette for the picture that it is") {
  std::size_t readers = 0;
  for (const bool isGrey : {false, true}) {
    const FewColors pictures(isGrey);
    const std::string png = quoted(pictures.file("a.png")), ppm = quoted(pictures.file("a.ppm"));
    const std::string tga = quoted(pictures.file("a.tga"));
    const auto check = [&](const std::string& probe, const std::string& command) {
      if (shell(probe).status != 0) return;
      ++readers;
      checkOutput(command, "");
    };
    check("command -v pngcheck", "pngcheck -q " + png);
    check("convert -version | grep ImageMagick",
          "for f in " + png + " " + tga +
              "; do convert \"$f\" -depth 8 rgb:- | cksum; done | uniq | sed 1d");
    check("/usr/bin/python3 -c 'import PIL'",
          "/usr/bin/python3 -c 'import sys; from PIL import Image; a, b = "
          "(Image.open(f).convert(\"RGB\").tobytes() for f in sys.argv[1:]); "
          "sys.exit(a != b)' " +
              png + " " + ppm);
    check("command -v oiiotool", "oiiotool --fail 0.0001 --diff " + tga + " " + png +
                                     " | grep -v -e PASS -e Computing || true");
    check("command -v pngtopam", "pngtopam " + png + " | ppmtoppm | cmp - " + ppm);
  }
  if (readers == 0) SKIP("no reader is installed");
}
