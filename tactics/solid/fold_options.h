// SPDX-License-Identifier: Apache-2.0
// The settings of folding out, described once: the command line, files of readers, help and the check of values read this list.
#pragma once

#include <span>

#include "tactics/option.h"
#include "tactics/solid/fold_out.h"

namespace tactics {

std::span<const Option> fold_options();

/// Those of `settings` that are not the default, put into `wish`; `path`: only for that object and what belongs to it
/// ("Table/Top"), where the settings of readers and of the whole drawing are refused. Throws Error(usage) at `place`.
void take_settings(FoldWish& wish, const Settings& settings, std::string_view path, std::string_view place);

}  // namespace tactics
