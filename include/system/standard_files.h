// Standard input, output and error of the process.
#pragma once

/// To be called once, by main, before any file is opened. Where the caller has closed one of the
/// three, its number is taken, so that no other file gets it and is read, or written with messages,
/// in its stead: reading standard input or writing standard output then fails (EBADF), and messages
/// go nowhere.
void keepStandardFiles();
