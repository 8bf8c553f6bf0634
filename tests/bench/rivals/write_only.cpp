// write_only FILE SIDE: writes a grey TGA file of SIDE x SIDE pixels and does nothing else.
#include <fcntl.h>
#include <unistd.h>

#include <cstdlib>
#include <vector>

int main(int count, char** words) {
  if (count != 3) return 2;
  const int side = std::atoi(words[2]);
  if (side < 1 || side > 65535) return 2;
  std::vector<unsigned char> bytes(18 + 3 * std::size_t(side) * std::size_t(side), 128);
  for (int i = 0; i < 18; ++i) bytes[std::size_t(i)] = 0;
  bytes[2] = 2;
  bytes[12] = bytes[14] = static_cast<unsigned char>(side & 255);
  bytes[13] = bytes[15] = static_cast<unsigned char>(side >> 8);
  bytes[16] = 24;
  bytes[17] = 0x20;
  const int file = open(words[1], O_WRONLY | O_CREAT | O_TRUNC, 0644);
  const ssize_t written = write(file, bytes.data(), bytes.size());
  return close(file) == 0 && written == ssize_t(bytes.size()) ? 0 : 1;
}
