// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/embedded.h"

#include <algorithm>
#include <span>
#include <vector>

#include "tactics/error.h"
#include "tactics/readers/read.h"

namespace tactics {

namespace {

constexpr int kMostPixels = 4000;

// RFC 4648, section 4; blanks are passed over. Nothing for other letters.
std::optional<std::vector<unsigned char>> from_base64(std::string_view text) {
    std::vector<unsigned char> bytes;
    unsigned word = 0, bits = 0;
    for (const char c : text) {
        unsigned digit = 0;
        if (c >= 'A' && c <= 'Z')
            digit = static_cast<unsigned>(c - 'A');
        else if (c >= 'a' && c <= 'z')
            digit = static_cast<unsigned>(c - 'a' + 26);
        else if (c >= '0' && c <= '9')
            digit = static_cast<unsigned>(c - '0' + 52);
        else if (c == '+')
            digit = 62;
        else if (c == '/')
            digit = 63;
        else if (c == '=')
            break;
        else if (c == ' ' || c == '\n' || c == '\r' || c == '\t')
            continue;
        else
            return std::nullopt;
        word = word << 6 | digit;
        bits += 6;
        if (bits >= 8) {
            bits -= 8;
            bytes.push_back(static_cast<unsigned char>(word >> bits & 255));
        }
    }
    return bytes;
}

bool is_of_the_web(std::span<const unsigned char> bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return text.starts_with("\x89PNG\r\n\x1A\n") || text.starts_with("\xFF\xD8\xFF") ||
           (text.starts_with("RIFF") && text.substr(std::min<std::size_t>(8, text.size())).starts_with("WEBP"));
}

}  // namespace

std::optional<Bitmap> embedded_picture(std::string_view address, const Rect& place) {
    const auto comma = address.find(',');
    if (!address.starts_with("data:image/") || comma == std::string_view::npos ||
        address.substr(0, comma).find(";base64") == std::string_view::npos)
        return std::nullopt;
    const auto bytes = from_base64(address.substr(comma + 1));
    if (!bytes || !is_of_the_web(*bytes)) return std::nullopt;
    try {
        Source source = memory_source(*bytes, "picture");
        const Image image = read_picture(source, {kMostPixels, false});
        return to_bitmap(image, place);
    } catch (const Error&) {
        return std::nullopt;
    }
}

}  // namespace tactics
