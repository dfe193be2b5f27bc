// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/data_uri.h"

namespace tactics {

namespace {

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

}  // namespace

std::optional<std::vector<unsigned char>> bytes_of_data_uri(std::string_view address) {
    const auto comma = address.find(',');
    if (!address.starts_with("data:") || comma == std::string_view::npos ||
        address.substr(0, comma).find(";base64") == std::string_view::npos)
        return std::nullopt;
    return from_base64(address.substr(comma + 1));
}

}  // namespace tactics
