// SHA-256 against the examples of the standard.
#include "system/sha256.h"

#include <string>

#include "check.h"

namespace {

std::string hex(const Digest& digest) {
  std::string text;
  for (const int byte : digest) {
    text += "0123456789abcdef"[byte / 16];
    text += "0123456789abcdef"[byte % 16];
  }
  return text;
}

std::string digestOf(const std::string& content) {
  return hex(sha256(content.data(), content.size()));
}

}  // namespace

// NIST, "Examples with Intermediate Values": SHA256; the last one is FIPS 180-2, appendix B.3.
TEST("the standard's examples have the standard's digests") {
  CHECK_EQUAL(digestOf("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK_EQUAL(digestOf("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
              "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  CHECK_EQUAL(digestOf(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK_EQUAL(digestOf(std::string(1000000, 'a')),
              "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST("a content in pieces has the digest of the whole") {
  std::string whole;
  for (int i = 0; i < 300; ++i) whole += char('a' + i % 23);
  for (std::size_t first : {0u, 1u, 55u, 56u, 63u, 64u, 65u, 128u, 299u}) {
    Sha256 hash;
    hash.add(whole.substr(0, first));
    for (std::size_t i = first; i < whole.size(); i += 7) hash.add(whole.substr(i, 7));
    CHECK_EQUAL(hex(hash.finish()), digestOf(whole));
  }
}

TEST("a number is added as eight bytes, the lowest first") {
  Sha256 hash;
  hash.addNumber(0x0102030405060708);
  CHECK_EQUAL(hex(hash.finish()), digestOf("\x08\x07\x06\x05\x04\x03\x02\x01"));
}
