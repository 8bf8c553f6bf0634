// How libFuzzer changes scenes: half of the time as it likes, else so that they stay scenes: one
// number becomes another, or one part between braces is replaced by another.
#include <algorithm>
#include <random>
#include <string_view>
#include <vector>

#include "fuzz.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t maxSize);

namespace {

using Random = std::minstd_rand;

/// A stretch of the text.
struct Part {
  std::size_t begin, size;
};

constexpr std::string_view kNumbers[] = {"0",
                                         "1",
                                         "-1",
                                         "2",
                                         "0.5",
                                         "-0.25",
                                         "3",
                                         "1e-3",
                                         "10",
                                         "100",
                                         "45",
                                         "90",
                                         "180",
                                         "1e6",
                                         "1e-6",
                                         "1e15",
                                         "1e-15",
                                         "1e38",
                                         "1e-38",
                                         "1e150",
                                         "1e-150",
                                         "-1e154",
                                         "1e-154",
                                         "1e300",
                                         "1e-300",
                                         "-1e308",
                                         "1e-320",
                                         "0.1",
                                         "0.3333333333333333",
                                         "1.0000000000000002",
                                         "0.9999999999999999",
                                         "16777217"};

std::size_t below(std::size_t bound, Random& random) { return random() % bound; }

std::vector<Part> numbersIn(const std::string& text) {
  std::vector<Part> parts;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find_first_of(" \t\r\n{}", at), text.size());
    const bool isNumber = text.find_first_of("0123456789", at) < end && text[at] < 'A';
    if (isNumber) parts.push_back({at, end - at});
    at = end + 1;
  }
  return parts;
}

/// Every word with the braces behind it and all between them.
std::vector<Part> blocksIn(const std::string& text) {
  std::vector<Part> parts;
  std::vector<std::size_t> open;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '{') {
      std::size_t word = text.find_last_not_of(" \t\r\n", at == 0 ? 0 : at - 1);
      word = word == std::string::npos ? 0 : text.find_last_of(" \t\r\n{}", word) + 1;
      open.push_back(std::min(word, at));
    } else if (text[at] == '}' && !open.empty()) {
      parts.push_back({open.back(), at + 1 - open.back()});
      open.pop_back();
    }
  }
  return parts;
}

/// `text` with one part replaced.
std::string changed(const std::string& text, Random& random) {
  std::string result = text;
  const std::vector<Part> numbers = numbersIn(text), blocks = blocksIn(text);
  if (random() % 4 != 0 && !numbers.empty()) {
    const Part part = numbers[below(numbers.size(), random)];
    const Part other = numbers[below(numbers.size(), random)];
    const bool isCopied = random() % 4 == 0;
    const std::string_view fresh = kNumbers[below(std::size(kNumbers), random)];
    result.replace(part.begin, part.size,
                   isCopied ? text.substr(other.begin, other.size) : std::string(fresh));
  } else if (!blocks.empty()) {
    const Part part = blocks[below(blocks.size(), random)];
    const Part other = blocks[below(blocks.size(), random)];
    const std::string copy = text.substr(other.begin, other.size);
    random() % 8 == 0 ? result.insert(part.begin, copy + " ")
                      : result.replace(part.begin, part.size, copy);
  }
  return result;
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t maxSize, unsigned seed) {
  Random random(seed);
  if (size == 0 || random() % 2 == 0) return LLVMFuzzerMutate(data, size, maxSize);
  std::string text(data, data + size - 1);
  for (std::size_t times = 1 + random() % 3; times > 0; --times) text = changed(text, random);
  const std::uint8_t options = random() % 4 == 0 ? std::uint8_t(random() >> 8) : data[size - 1];
  text.resize(std::min(text.size(), maxSize - 1));
  std::copy(text.begin(), text.end(), data);
  data[text.size()] = options;
  return text.size() + 1;
}
