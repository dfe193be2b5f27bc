// SPDX-License-Identifier: Apache-2.0
// Checks of every reader before it allocates memory: refuses impossible sizes claimed by a file.
#pragma once

#include <string_view>

namespace tactics {

/// Throws Error(failed) when a picture of that size is empty or past the limits of read.h.
void check_claimed_size(std::string_view name, long long width, long long height);

/// The same for pictures that can only be decoded whole; `what` says which kind that is ("an interlaced PNG").
void check_whole_size(std::string_view name, std::string_view what, long long width, long long height);

/// Throws Error(failed): `NAME: is cut short at line N of M (...)`, counting lines from 1; line 0 = before the first.
/// `pass` is for files that come in several passes over the picture, 0 when there is only one.
[[noreturn]] void throw_cut_short(std::string_view name, long long line, long long lines, int pass = 0);

/// Throws Error(failed): `NAME: is damaged at line N of M: what the library says (...)`, in the same way.
[[noreturn]] void throw_damaged(std::string_view name, long long line, long long lines, std::string_view why, int pass = 0);

}  // namespace tactics
