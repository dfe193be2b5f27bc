// SPDX-License-Identifier: Apache-2.0
#include "tactics/coding/bytes.h"

#include <array>
#include <bit>

namespace tactics {

namespace {

// What a byte does to the sum when so many others follow it: eight are looked up at once and need not wait for each other.
using CrcTables = std::array<std::array<std::uint32_t, 256>, 8>;
constexpr CrcTables kCrc = [] {
    CrcTables tables{};
    for (std::uint32_t i = 0; i < 256; ++i) {
        std::uint32_t rest = i;
        for (int bit = 0; bit < 8; ++bit) rest = (rest & 1u) != 0 ? rest >> 1 ^ 0xEDB88320u : rest >> 1;
        tables[0][i] = rest;
    }
    for (std::size_t after = 1; after < tables.size(); ++after)
        for (std::size_t i = 0; i < 256; ++i) {
            const std::uint32_t rest = tables[after - 1][i];
            tables[after][i] = rest >> 8 ^ tables[0][rest & 0xFFu];
        }
    return tables;
}();

}  // namespace

void append_number(std::string& bytes, std::uint64_t number, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) bytes += static_cast<char>(static_cast<unsigned char>(number >> (8 * i)));
}

void append_double(std::string& bytes, double number) { append_number(bytes, std::bit_cast<std::uint64_t>(number), 8); }

std::uint32_t crc32_of(std::string_view bytes) noexcept {
    std::uint32_t rest = 0xFFFFFFFFu;
    for (; bytes.size() >= kCrc.size(); bytes.remove_prefix(kCrc.size())) {
        std::uint32_t next = 0;
        for (std::size_t i = 0; i < kCrc.size(); ++i) {
            const std::uint32_t mixed = static_cast<unsigned char>(bytes[i]) ^ (i < 4 ? rest >> (8 * i) & 0xFFu : 0);
            next ^= kCrc[kCrc.size() - 1 - i][mixed];
        }
        rest = next;
    }
    for (const char byte : bytes) rest = rest >> 8 ^ kCrc[0][(rest ^ static_cast<unsigned char>(byte)) & 0xFFu];
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
