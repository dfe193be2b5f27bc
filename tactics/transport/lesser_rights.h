// SPDX-License-Identifier: Apache-2.0
// A program that was started by root and needs nothing of root's gives its rights up before it reads what a stranger sent.
#pragma once

namespace tactics {

/// Becomes the user that print systems have for filters ("lp", else "nobody"), with that user's group and no other, for good.
/// Does nothing where this process is not root. Called while there is one thread. Throws Error(failed) where it cannot be done:
/// going on as root would be worse.
void take_lesser_rights();

}  // namespace tactics
