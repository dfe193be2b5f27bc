// SPDX-License-Identifier: Apache-2.0
// What mending did, in JSON.
#pragma once

#include <string>

#include "tactics/job/mending.h"
#include "tactics/text/json.h"

namespace tactics {

std::string trust_json(const Trust& trust);
/// Members for what is told; `drawing` is its place on the page.
void add_mending(JsonObject& json, const MendingTold& told, const Rect& drawing);

}  // namespace tactics
