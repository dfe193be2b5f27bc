// SPDX-License-Identifier: Apache-2.0
// zlib's format (RFC 1950), for PDF and PNG.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace tactics {

/// Compresses bytes and appends them to a string. Level 1 to 9.
class Deflater {
public:
    explicit Deflater(int level);
    ~Deflater();
    Deflater(const Deflater&) = delete;
    Deflater& operator=(const Deflater&) = delete;

    void add(std::span<const std::uint8_t> bytes);
    std::string finish();

private:
    void pump(int flush);
    struct Stream;
    std::unique_ptr<Stream> stream_;
    std::string out_;
};

std::string deflated(std::string_view text, int level);

}  // namespace tactics
