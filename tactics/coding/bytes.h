// SPDX-License-Identifier: Apache-2.0
// Numbers as bytes, the lowest first, as the container of container.h has them; and the sum that tells whether bytes are whole.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace tactics {

/// Adds the lowest `size` bytes of a number.
void append_number(std::string& bytes, std::uint64_t number, std::size_t size);
/// An IEEE 754 double, bit for bit.
void append_double(std::string& bytes, double number);

/// CRC-32 of ISO 3309, as PNG and gzip have it: of "123456789" it is CBF43926h.
std::uint32_t crc32_of(std::string_view bytes) noexcept;

/// Takes numbers from the beginning of bytes. Behind their end it gives zeros, and `whole` says so.
class ByteReader {
public:
    explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}
    std::uint64_t number(std::size_t size) noexcept;
    double real() noexcept;                            ///< as append_double wrote it
    std::string_view take(std::size_t size) noexcept;  ///< so many bytes, or none if there are not so many
    bool whole() const noexcept { return whole_; }     ///< all that was asked for was there
    std::size_t left() const noexcept { return bytes_.size(); }

private:
    std::string_view bytes_;
    bool whole_ = true;
};

}  // namespace tactics
