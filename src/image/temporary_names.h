// TemporaryNames: the names that a signal handler has to remove, and who else hears of a signal.
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

/// From now on a signal that asks the program to end (see removeTemporaryOnSignals) writes its
/// number, one byte, to `descriptor`, and the program goes on: whoever reads there has a tenth of a
/// second to call endOnSignal; a signal after that ends the program without further ado. With -1
/// signals end the program at once again, and on return nobody writes to the old descriptor any
/// more. `descriptor` must be non-blocking.
void passSignalsTo(int descriptor);

/// What a signal does that is not passed: removes the temporary files and ends the program with
/// status 128 + `signal`.
[[noreturn]] void endOnSignal(int signal);
