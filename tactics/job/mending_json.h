// SPDX-License-Identifier: Apache-2.0
// The changes by mending, as JSON.
#pragma once

#include <string>

#include "tactics/job/mending.h"
#include "tactics/text/json.h"

namespace tactics {

std::string trust_json(const Trust& trust);
/// The members of a report; `drawing` is the place of the drawing on the page.
void add_mending(JsonObject& json, const MendingTold& told, const Rect& drawing);

}  // namespace tactics
