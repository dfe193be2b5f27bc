// SPDX-License-Identifier: Apache-2.0
// What a machine is sent behind a job that was cancelled.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "tactics/transport/delivery.h"

namespace tactics {

/// Hands over the bytes that end a job, unless the user gives up waiting for that, too, or the machine takes nothing for 5 s.
/// What to say if they did not go; empty: they did.
std::string end_job(Channel& channel, std::string_view end, const std::function<bool()>& given_up);

}  // namespace tactics
