// TemporaryNames: the names that a signal handler has to remove.
#pragma once
#include <string>

/// Creates the file `name` (O_EXCL, for writing) and notes its name for the handler, as one step
/// that no signal can split. Gives the descriptor, or -1 with errno set; on success `slot` is
/// what forgetTemporary() takes.
int createTemporary(const std::string& name, unsigned permissions, int& slot);

/// The file of `slot` is gone: renamed or removed.
void forgetTemporary(int slot);
