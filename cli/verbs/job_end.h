// SPDX-License-Identifier: Apache-2.0
// The end of a cancelled job, as sent to a machine.
#pragma once

#include <functional>
#include <string_view>

#include "tactics/text/phrase.h"
#include "tactics/transport/delivery.h"

namespace tactics {

/// Sends the bytes that end a job, unless the user cancels again or the machine accepts nothing for 5 s. Returns a message if
/// they were not sent; empty: they were.
Phrase end_job(Channel& channel, std::string_view end, const std::function<bool()>& given_up);

}  // namespace tactics
