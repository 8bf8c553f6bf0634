// PPM, PGM and PFM reader.
#include <cstring>

#include "image/byte_reader.h"
#include "image/netpbm.h"

namespace {

constexpr unsigned kMostSide = 0x7FFFFFFF, kMostSample = 65535;

bool isSpace(unsigned c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
bool isDigit(unsigned c) { return c >= '0' && c <= '9'; }

class NetpbmFile {
 public:
  NetpbmFile(const Bytes& bytes, const std::string& name) : bytes_(bytes), reader_(bytes, name) {}

  Image read() {
    readKind();
    width_ = takeNumber("width", 1, kMostSide);
    height_ = takeNumber("height", 1, kMostSide);
    if (isFloat_) {
      readScale();
    } else {
      maximum_ = takeNumber("maximum", 1, kMostSample);
      takeOneSpace();
    }
    checkLength();
    Image image(static_cast<int>(width_), static_cast<int>(height_));
    for (int row = 0; row < image.Height(); ++row) {
      const int y = isFloat_ ? row : image.Height() - 1 - row;
      for (int x = 0; x < image.Width(); ++x) image.setPixel(x, y, takePixel());
    }
    return image;
  }

 private:
  void readKind() {
    const unsigned kind = reader_.take(2, "kind of picture")[1];
    if (kind == '1' || kind == '4' || kind == '7') {
      reader_.fail(std::string("P") + char(kind) +
                   " pictures are not supported, only P2, P3, P5, " + "P6, PF and Pf");
    }
    isFloat_ = kind == 'F' || kind == 'f';
    isText_ = kind == '2' || kind == '3';
    channels_ = kind == '3' || kind == '6' || kind == 'F' ? 3 : 1;
  }

  bool atEnd() const { return reader_.remaining() == 0; }
  unsigned next() const { return bytes_[reader_.position()]; }

  void skipSpace() {
    while (!atEnd() && (isSpace(next()) || (next() == '#' && !isFloat_))) {
      if (next() == '#') {
        while (!atEnd() && next() != '\n' && next() != '\r') reader_.take(1, "comment");
      } else {
        reader_.take(1, "blank");
      }
    }
  }

  /// Behind the head: one white space, and after it the pixels.
  void takeOneSpace() {
    if (!isSpace(reader_.takeByte("end of the head"))) {
      reader_.fail("expected a line break behind the head");
    }
  }

  unsigned takeNumber(const char* what, unsigned least, unsigned most) {
    skipSpace();
    const std::string expected = std::string("expected a ") + what + " of " +
                                 std::to_string(least) + " to " + std::to_string(most);
    if (atEnd() || !isDigit(next())) reader_.fail(expected + ", found none");
    std::uint64_t value = 0;
    while (!atEnd() && isDigit(next()) && value <= most) {
      value = value * 10 + (reader_.takeByte("number") - '0');
    }
    if (value < least || value > most) reader_.fail(expected + ", found " + std::to_string(value));
    return static_cast<unsigned>(value);
  }

  /// A number such as -1.0, of which only the sign counts: below 0 the low byte comes first.
  void readScale() {
    skipSpace();
    std::string word;
    while (!atEnd() && !isSpace(next()) && word.size() < 64) {
      word += static_cast<char>(reader_.takeByte("scale"));
    }
    const bool isNumber = word.find_first_of("0123456789") != std::string::npos &&
                          word.find_first_not_of("+-.0123456789eE") == std::string::npos;
    if (!isNumber) reader_.fail("expected a scale such as -1");
    lowFirst_ = word[0] == '-';
    takeOneSpace();
  }

  std::size_t sampleBytes() const {
    return isFloat_ ? 4 : maximum_ > 255 ? 2 : isText_ ? 2 : 1;  // text: a digit and a blank
  }

  /// Before the image is made: can the rest of the file hold so many pixels at all?
  void checkLength() const {
    const std::uint64_t pixels = std::uint64_t{width_} * height_;  // below 2^62
    const std::size_t size = isText_ ? 2 : sampleBytes();
    const std::size_t room = reader_.remaining() + (isText_ ? 1 : 0);  // no blank after the last
    if (pixels <= room / (size * channels_)) return reader_.checkSize(width_, height_);
    reader_.fail("expected the data of " + std::to_string(width_) + " x " +
                 std::to_string(height_) + " pixels, found " + std::to_string(reader_.remaining()) +
                 " bytes");
  }

  std::uint8_t takeSample() {
    if (isFloat_) return byteFromComponent(takeFloat());
    unsigned value = 0;
    if (isText_) {
      value = takeNumber("sample", 0, maximum_);
    } else {
      const std::uint8_t* const bytes = reader_.take(sampleBytes(), "sample");
      value = maximum_ > 255 ? bytes[0] * 256u + bytes[1] : bytes[0];
      if (value > maximum_) {
        reader_.fail("expected a sample of at most " + std::to_string(maximum_) + ", found " +
                     std::to_string(value));
      }
    }
    return static_cast<std::uint8_t>((value * 255 + maximum_ / 2) / maximum_);
  }

  float takeFloat() {
    const std::uint8_t* const b = reader_.take(4, "sample");
    const std::uint8_t turned[4] = {b[3], b[2], b[1], b[0]};
    const std::uint32_t bits = bigEndian32(lowFirst_ ? turned : b);
    float value = 0;
    std::memcpy(&value, &bits, sizeof value);
    return value;
  }

  Rgb8 takePixel() {
    Rgb8 pixel;
    pixel.r = takeSample();
    pixel.g = channels_ == 3 ? takeSample() : pixel.r;
    pixel.b = channels_ == 3 ? takeSample() : pixel.r;
    return pixel;
  }

  const Bytes& bytes_;
  ByteReader reader_;
  bool isFloat_ = false, isText_ = false, lowFirst_ = false;
  unsigned channels_ = 0, width_ = 0, height_ = 0, maximum_ = 255;
};

}  // namespace

bool isNetpbm(const Bytes& bytes) {
  if (bytes.size() < 3 || bytes[0] != 'P') return false;
  const bool isKind = (bytes[1] >= '1' && bytes[1] <= '7') || bytes[1] == 'F' || bytes[1] == 'f';
  return isKind && (isSpace(bytes[2]) || bytes[2] == '#');
}

Image decodeNetpbm(const Bytes& bytes, const std::string& name) {
  if (!isNetpbm(bytes)) throw ImageError(name, "expected a PPM or PFM file");
  return NetpbmFile(bytes, name).read();
}
