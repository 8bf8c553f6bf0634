// PPM, PGM and PFM: a head of words (the kind, width, height, and the largest sample or, of floats,
// a scale), one white space, then the samples, as bytes or as decimal numbers.
//   P2, P3   grey and colours in decimal numbers, with white space between
//   P5, P6   grey and colours in bytes; two each, the high one first, where the largest is over 255
//   Pf, PF   grey and colours in floats of 32 bits; a scale below 0 says that low bytes come first
// A row stands from the left; the top row comes first, but of floats the bottom one.
#include <cstring>

#include "image/picture_file.h"

namespace {

constexpr unsigned kMostSide = 0x7FFFFFFF, kMostSample = 65535;

bool isSpace(unsigned c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
bool isDigit(unsigned c) { return c >= '0' && c <= '9'; }

/// Of a file that is written: each word of it in a line of its own, but for the sides.
Bytes headOf(const std::string& kind, int width, int height, const std::string& range) {
  const std::string head =
      kind + "\n" + std::to_string(width) + " " + std::to_string(height) + "\n" + range + "\n";
  return {head.begin(), head.end()};
}

/// Takes the head, which says how samples are stored; then each sample by the same function.
class NetpbmReader {
 public:
  NetpbmReader(const Bytes& bytes, const std::string& name, FloatImage* exact)
      : reader_(bytes, name), exact_(exact) {}

  Image read() {
    const unsigned kind = reader_.take(2, "kind of picture")[1];
    reader_.check(kind != '1' && kind != '4' && kind != '7', "P", char(kind),
                  " pictures are not supported, only P2, P3, P5, P6, PF and Pf");
    isFloat_ = kind == 'F' || kind == 'f';
    isText_ = kind == '2' || kind == '3';
    isGrey_ = kind != '3' && kind != '6' && kind != 'F';
    const unsigned width = takeNumber("width", 1, kMostSide);
    const unsigned height = takeNumber("height", 1, kMostSide);
    if (isFloat_) {
      takeScale();
    } else {
      maximum_ = takeNumber("maximum", 1, kMostSample);
    }
    reader_.check(isSpace(reader_.takeByte("end of the head")),
                  "expected a line break behind the head");
    // Whether the file can hold the samples is known before memory is asked for the picture.
    // A number takes at least a digit and a blank, but for the last one.
    const std::size_t size = isText_ ? 2 : isFloat_ ? 4 : maximum_ > 255 ? 2 : 1;
    const std::size_t room = reader_.remaining() + (isText_ ? 1 : 0);
    reader_.checkSize(width, height, room / (size * (isGrey_ ? 1 : 3)), reader_.remaining());
    return takePixels(static_cast<int>(width), static_cast<int>(height));
  }

 private:
  /// The file goes on with a byte of this kind.
  bool isNext(bool (*kind)(unsigned)) const {
    return reader_.remaining() > 0 && kind(reader_.peek());
  }

  /// A PFM has no comments: its # is a fault of the number that should stand there.
  void skipSpaceAndComments() {
    const auto inLine = [](unsigned c) { return c != '\n' && c != '\r'; };
    while (isNext([](unsigned c) { return isSpace(c) || c == '#'; })) {
      if (reader_.peek() == '#' && isFloat_) return;
      const bool isComment = reader_.takeByte("blank") == '#';
      while (isComment && isNext(inLine)) reader_.takeByte("comment");
    }
  }

  /// A decimal number; at most one digit is taken too many, so that it cannot overflow.
  unsigned takeNumber(const char* what, unsigned least, unsigned most) {
    skipSpaceAndComments();
    const bool isThere = isNext(isDigit);
    std::uint64_t value = 0;
    while (isNext(isDigit) && value <= most) value = value * 10 + reader_.takeByte("number") - '0';
    reader_.check(isThere && value >= least && value <= most, "expected a ", what, " of ", least,
                  " to ", most, ", found ", isThere ? std::to_string(value) : "none");
    return static_cast<unsigned>(value);
  }

  /// A number such as -1.0, of which only the sign counts: below 0 the low byte comes first.
  void takeScale() {
    skipSpaceAndComments();
    std::string word;
    while (isNext([](unsigned c) { return !isSpace(c); }) && word.size() < 64) {
      word += static_cast<char>(reader_.takeByte("scale"));
    }
    const bool isNumber = word.find_first_of("0123456789") != std::string::npos &&
                          word.find_first_not_of("+-.0123456789eE") == std::string::npos;
    reader_.check(isNumber, "expected a scale such as -1");
    isLowFirst_ = word[0] == '-';
  }

  /// The top row comes first, but of floats the bottom one.
  Image takePixels(int width, int height) {
    const bool isExact = exact_ && (isFloat_ || maximum_ > 255);
    Image image(width, height);
    if (isExact) *exact_ = FloatImage(width, height);
    for (int row = 0; row < height; ++row) {
      const int y = isFloat_ ? row : height - 1 - row;
      for (int x = 0; x < width; ++x) {
        Rgb8 pixel;
        Vec3f color;
        pixel.r = takeSample(color[0]);
        pixel.g = isGrey_ ? pixel.r : takeSample(color[1]);
        pixel.b = isGrey_ ? pixel.r : takeSample(color[2]);
        if (isGrey_) color = Vec3f(color[0], color[0], color[0]);
        image.setPixel(x, y, pixel);
        if (isExact) exact_->setPixel(x, y, color);
      }
    }
    return image;
  }

  /// As a byte: a sample s of at most m as 255 s / m, rounded to nearest; and as it stands in
  /// `exact`, m being 1.
  std::uint8_t takeSample(float& exact) {
    if (isFloat_) return byteFromComponent(exact = takeFloat());
    unsigned value = isText_ ? takeNumber("sample", 0, maximum_) : reader_.takeByte("sample");
    if (!isText_ && maximum_ > 255) value = value * 256 + reader_.takeByte("sample");
    reader_.check(value <= maximum_, "expected a sample of at most ", maximum_, ", found ", value);
    exact = float(value) / float(maximum_);
    return byteFromSample(value, maximum_);
  }

  /// Of either byte order, on a machine of either.
  float takeFloat() {
    const std::uint8_t* const b = reader_.take(4, "sample");
    const std::uint32_t bits = isLowFirst_ ? littleEndian32(b) : bigEndian32(b);
    float value = 0;
    std::memcpy(&value, &bits, sizeof value);
    return value;
  }

  ByteReader reader_;
  FloatImage* const exact_;  // not owned; may be null
  bool isFloat_ = false, isText_ = false, isGrey_ = false, isLowFirst_ = false;
  unsigned maximum_ = 255;
};

}  // namespace

Bytes ppmHead(int width, int height) { return headOf("P6", width, height, "255"); }

void encodePfm(int width, int height, const std::function<Vec3f(int x, int y)>& colorOf,
               const Sink& sink) {
  static_assert(sizeof(float) == 4);
  sink(headOf("PF", width, height, "-1"));
  for (int y = 0; y < height; ++y) {
    Bytes row;
    for (int x = 0; x < width; ++x) {
      const Vec3f color = colorOf(x, y);
      for (const float component : {color.r(), color.g(), color.b()}) {
        // Byte by byte, as the file has the low one first on every machine.
        std::uint32_t bits = 0;
        std::memcpy(&bits, &component, sizeof bits);
        appendLittleEndian(bits, 4, row);
      }
    }
    sink(row);
  }
}

/// No TGA begins so: its second byte is 0 or 1.
bool isNetpbm(const Bytes& bytes) {
  if (bytes.size() < 3 || bytes[0] != 'P') return false;
  const bool isKind = (bytes[1] >= '1' && bytes[1] <= '7') || bytes[1] == 'F' || bytes[1] == 'f';
  return isKind && (isSpace(bytes[2]) || bytes[2] == '#');
}

Image decodeNetpbm(const Bytes& bytes, const std::string& name, FloatImage* exact) {
  if (!isNetpbm(bytes)) throw ImageError(name, "expected a PPM or PFM file");
  return NetpbmReader(bytes, name, exact).read();
}
