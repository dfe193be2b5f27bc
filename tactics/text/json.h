// SPDX-License-Identifier: Apache-2.0
// JSON out, for scripts.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tactics/text/phrase.h"

namespace tactics {

/// A JSON string with its quotes. A byte that is not UTF-8 (possible in file names) becomes the lone surrogate \udc80 + (byte -
/// 80h), as in Python's "surrogateescape", so that the exact name can be recovered.
std::string json_text(std::string_view bytes);
std::string json_array(const std::vector<std::string>& values);      ///< of JSON
std::string json_text_array(const std::vector<std::string>& texts);  ///< of bytes
std::string json_text_array(const std::vector<Phrase>& phrases);     ///< the same in English, which programs read

/// An object on one line; members keep the order of adding.
class JsonObject {
public:
    void add(std::string_view name, std::string_view text) { add_raw(name, json_text(text)); }
    void add(std::string_view name, const char* text) { add(name, std::string_view(text)); }
    void add(std::string_view name, double value);
    void add_raw(std::string_view name, std::string_view json);
    std::string text() const { return "{" + members_ + "}"; }

private:
    std::string members_;
};

/// A whole answer of --json. Its first member is the version of the format that the files in cli/schemas/ describe. Adding
/// members keeps the version; removing or renaming one, or changing what it means, raises it.
class JsonAnswer : public JsonObject {
public:
    static constexpr int kSchema = 1;
    JsonAnswer() { add("schema", kSchema); }
};

}  // namespace tactics
