#include "cli/json.h"

#include "tactics/units.h"

namespace tactics {

namespace {

// Length of the well-formed UTF-8 sequence at the start of `text`, or 0 (Unicode 15, table 3-7: no overlong forms, no
// surrogates, nothing above U+10FFFF).
std::size_t sequence_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
    const auto follows = [&](std::size_t i) { return byte(i) >= 0x80 && byte(i) <= 0xbf; };
    const unsigned first = byte(0);
    if (first < 0x80) return 1;
    if (first >= 0xc2 && first <= 0xdf) return follows(1) ? 2 : 0;
    if (first >= 0xe0 && first <= 0xef) {
        const unsigned low = first == 0xe0 ? 0xa0 : 0x80;
        const unsigned high = first == 0xed ? 0x9f : 0xbf;
        return byte(1) >= low && byte(1) <= high && follows(2) ? 3 : 0;
    }
    if (first >= 0xf0 && first <= 0xf4) {
        const unsigned low = first == 0xf0 ? 0x90 : 0x80;
        const unsigned high = first == 0xf4 ? 0x8f : 0xbf;
        return byte(1) >= low && byte(1) <= high && follows(2) && follows(3) ? 4 : 0;
    }
    return 0;
}

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
        const std::size_t length = sequence_length(bytes);
        if (length == 0) {
            add_escape(json, 0xdc00u + byte);
        } else if (byte == '"' || byte == '\\') {
            json += '\\';
            json += bytes[0];
        } else if (byte < 0x20 || byte == 0x7f) {
            add_escape(json, byte);
        } else {
            json += bytes.substr(0, length);
        }
        bytes.remove_prefix(length == 0 ? 1 : length);
    }
    return json + "\"";
}

std::string json_array(const std::vector<std::string>& values) {
    std::string json = "[";
    for (const auto& value : values) json += (json.size() > 1 ? "," : "") + value;
    return json + "]";
}

void JsonObject::add(std::string_view name, double value) { add_raw(name, to_text(value)); }

void JsonObject::add_raw(std::string_view name, std::string_view json) {
    members_ += (members_.empty() ? "" : ",") + json_text(name) + ":" + std::string(json);
}

}  // namespace tactics
