// SPDX-License-Identifier: Apache-2.0
#include "tactics/text/json.h"

#include "tactics/text/number.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

void add_escape(std::string& json, unsigned unit) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    json += "\\u";
    for (int shift = 12; shift >= 0; shift -= 4) json += kDigits[(unit >> shift) & 15];
}

}  // namespace

std::string json_text(std::string_view bytes) {
    std::string json = "\"";
    while (!bytes.empty()) {
        const auto byte = static_cast<unsigned char>(bytes[0]);
        std::string_view rest = bytes;
        const char32_t letter = take_letter(rest);
        if (letter == kNoLetter) {
            add_escape(json, 0xdc00u + byte);
        } else if (byte == '"' || byte == '\\') {
            json += '\\';
            json += bytes[0];
        } else if (steers(letter)) {
            add_escape(json, letter);
        } else {
            json += bytes.substr(0, bytes.size() - rest.size());
        }
        bytes = rest;
    }
    return json + "\"";
}

std::string json_array(const std::vector<std::string>& values) {
    std::string json = "[";
    for (const auto& value : values) json += (json.size() > 1 ? "," : "") + value;
    return json + "]";
}

std::string json_text_array(const std::vector<std::string>& texts) {
    std::vector<std::string> values;
    for (const auto& text : texts) values.push_back(json_text(text));
    return json_array(values);
}

void JsonObject::add(std::string_view name, double value) { add_raw(name, to_text(value)); }

void JsonObject::add_raw(std::string_view name, std::string_view json) {
    members_ += (members_.empty() ? "" : ",") + json_text(name) + ":" + std::string(json);
}

std::string json_text_array(const std::vector<Phrase>& phrases) { return json_text_array(in_language(phrases, "en")); }

}  // namespace tactics
