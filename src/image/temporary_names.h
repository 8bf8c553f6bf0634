// TemporaryNames: the names that a signal handler has to remove.
#pragma once
#include <string>

/// Creates the file `name` (O_EXCL, for writing) and notes its name for the handler, as one step
/// that no signal can split. Gives the descriptor, or -1 with errno set; on success `slot` is
/// what forgetTemporary() takes.
int createTemporary(const std::string& name, unsigned permissions, int& slot);

/// The file of `slot` is gone: renamed or removed.
void forgetTemporary(int slot);

/// Does not return once a signal handler, in another thread, has begun to end the program: what
/// fails from then on (a rename of a file that the handler has removed) is no error to report.
void waitIfEnding();
