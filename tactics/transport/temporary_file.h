// SPDX-License-Identifier: Apache-2.0
// A file without a name, for bytes that a program needs as a file: gone once it is closed, however the process ends.
#pragma once

#include <cstdio>
#include <memory>

#include "tactics/text/phrase.h"

namespace tactics {

using TemporaryFile = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// Opens one for reading and writing, in the first folder that takes it: $TMPDIR, /tmp, /var/tmp, $XDG_RUNTIME_DIR. A variable
/// counts if it names a folder from the root on (POSIX.1-2017, section 8.3; XDG Base Directory Specification 0.8). Children do
/// not inherit it. Null with errno of the first folder if none does. Thread-safe as long as nobody changes the environment.
TemporaryFile temporary_file();

/// "make room in FOLDER, or name another folder with TMPDIR": what a user can do where temporary_file() is null or full.
Phrase temporary_file_cure();

}  // namespace tactics
