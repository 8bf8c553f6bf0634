// Reading a whole file into memory: a regular file, a FIFO, or a device that ends.
// Memory grows with the bytes that arrive, never with a size that was only declared.
#pragma once
#include <string>

/// Stores everything in `filename` in `bytes` and returns true. Otherwise returns false and says
/// in `reason` why, without the file's name. Waits for the writer of a FIFO. Throws std::bad_alloc
/// where memory does not hold it.
bool readWholeFile(const std::string& filename, std::string& bytes, std::string& reason);

/// The same for standard input, which stays open.
bool readStandardInput(std::string& bytes, std::string& reason);
