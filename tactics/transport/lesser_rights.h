// SPDX-License-Identifier: Apache-2.0
// A program that was started by root and needs nothing of root's gives its rights up before it reads what a stranger sent.
#pragma once

namespace tactics {

/// Permanently becomes the user for print filters ("lp", else "nobody"), with only that user's group. Does nothing if this
/// process is not root. Call it while there is one thread. Throws Error(failed) if it is impossible, because continuing as root
/// would be worse.
void take_lesser_rights();

}  // namespace tactics
