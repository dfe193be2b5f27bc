// SPDX-License-Identifier: Apache-2.0
#include "tactics/coding/bytes.h"

#include <array>
#include <bit>

namespace tactics {

namespace {

constexpr std::array<std::uint32_t, 256> crc_table() {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t i = 0; i < 256; ++i) {
        std::uint32_t rest = i;
        for (int bit = 0; bit < 8; ++bit) rest = (rest & 1u) != 0 ? rest >> 1 ^ 0xEDB88320u : rest >> 1;
        table[i] = rest;
    }
    return table;
}

constexpr std::array<std::uint32_t, 256> kCrcTable = crc_table();

}  // namespace

void append_number(std::string& bytes, std::uint64_t number, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) bytes += static_cast<char>(static_cast<unsigned char>(number >> (8 * i)));
}

void append_double(std::string& bytes, double number) { append_number(bytes, std::bit_cast<std::uint64_t>(number), 8); }

std::uint32_t crc32_of(std::string_view bytes) noexcept {
    std::uint32_t rest = 0xFFFFFFFFu;
    for (const char byte : bytes) rest = rest >> 8 ^ kCrcTable[(rest ^ static_cast<unsigned char>(byte)) & 0xFFu];
    return ~rest;
}

std::string_view ByteReader::take(std::size_t size) noexcept {
    if (size > bytes_.size()) {
        whole_ = false;
        bytes_ = {};
        return {};
    }
    const std::string_view taken = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
    return taken;
}

std::uint64_t ByteReader::number(std::size_t size) noexcept {
    std::uint64_t number = 0;
    const std::string_view taken = take(size);
    for (std::size_t i = 0; i < taken.size(); ++i) number |= std::uint64_t{static_cast<unsigned char>(taken[i])} << (8 * i);
    return number;
}

double ByteReader::real() noexcept { return std::bit_cast<double>(number(8)); }

}  // namespace tactics
