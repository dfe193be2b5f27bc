// SPDX-License-Identifier: Apache-2.0
// A page said in words, for programs.
#pragma once

#include <span>

#include "tactics/page.h"
#include "tactics/text/json.h"

namespace tactics {

/// Adds what the first page is called and how large it is, its named things (objects_json) and its main lines and areas, with
/// places in mm on it, all of it in English, for programs; and the words for all pages, line by line, in the language of the
/// page, and which that is.
void add_description(JsonObject& json, std::span<const Page> pages);

}  // namespace tactics
