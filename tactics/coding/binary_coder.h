// SPDX-License-Identifier: Apache-2.0
// Adaptive binary arithmetic coding: each decision costs what it tells, and chances are learned from the decisions before.
//
// A range coder with carry, after G. N. N. Martin, "Range encoding" (1979); chances of 16 bits move by 1/32 of what they lack.
// Both sides are whole numbers only, so that any machine gives the same bytes.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace tactics {

/// The chance of a decision to be 0, out of 65536. It stays between 32 and 65504, so that nothing becomes impossible.
///
/// It is kept with its highest bit turned, so that one of zeros is even. GCC 12.2 with -ftrivial-auto-var-init=zero, as this
/// project is built, was seen to leave arrays of chances in a local variable at zero, whatever their initializer said.
class Chance {
public:
    std::uint32_t of_zero() const noexcept { return turned_ ^ kEven; }
    void learn(bool bit) noexcept {
        const std::uint32_t now = of_zero();
        turned_ = static_cast<std::uint16_t>((bit ? now - (now >> kPace) : now + ((65536u - now) >> kPace)) ^ kEven);
    }

private:
    static constexpr unsigned kPace = 5;
    static constexpr std::uint32_t kEven = 32768;
    std::uint16_t turned_ = 0;
};

class BinaryEncoder {
public:
    explicit BinaryEncoder(std::string& bytes) : bytes_(bytes) {}
    void put(Chance& chance, bool bit) {
        const std::uint32_t bound = (range_ >> 16) * chance.of_zero();
        if (bit) {
            low_ += bound;
            range_ -= bound;
        } else {
            range_ = bound;
        }
        chance.learn(bit);
        while (range_ < kLeastRange) {
            range_ <<= 8;
            shift();
        }
    }
    /// So many zeros one after the other, quicker than one by one.
    void put_zeros(Chance& chance, std::size_t count) {
        Chance now = chance;
        std::uint32_t range = range_;
        while (count > 0) {
            for (; count > 0 && range >= kLeastRange; --count) {
                range = (range >> 16) * now.of_zero();
                now.learn(false);
            }
            for (; range < kLeastRange; range <<= 8) shift();
        }
        range_ = range;
        chance = now;
    }
    /// Decisions that are as likely as not, the highest first.
    void put_even(std::uint32_t bits, unsigned count) {
        while (count-- > 0) {
            range_ >>= 1;
            if ((bits >> count & 1u) != 0) low_ += range_;
            while (range_ < kLeastRange) {
                range_ <<= 8;
                shift();
            }
        }
    }
    /// Once, after the last.
    void finish() {
        for (int i = 0; i < 5; ++i) shift();
    }

private:
    friend class BinaryDecoder;
    static constexpr std::uint32_t kLeastRange = 1u << 24;
    void shift() {
        if (low_ < 0xFF000000u || low_ > 0xFFFFFFFFu) {
            const auto carry = static_cast<unsigned char>(low_ >> 32);
            if (begun_) bytes_ += static_cast<char>(static_cast<unsigned char>(kept_ + carry));
            begun_ = true;
            for (; waiting_ > 0; --waiting_) bytes_ += static_cast<char>(static_cast<unsigned char>(0xFFu + carry));
            kept_ = static_cast<unsigned char>(low_ >> 24);
        } else {
            ++waiting_;
        }
        low_ = (low_ & 0x00FFFFFFu) << 8;
    }

    std::string& bytes_;
    std::uint64_t low_ = 0;
    std::uint32_t range_ = 0xFFFFFFFFu;
    std::size_t waiting_ = 0;
    unsigned char kept_ = 0;
    bool begun_ = false;
};

/// Behind the end of its bytes it decides by zeros; whole() tells at the end whether all bytes, and no others, were taken.
class BinaryDecoder {
public:
    explicit BinaryDecoder(std::string_view bytes) : at_(bytes.data()), end_(bytes.data() + bytes.size()) {
        for (int i = 0; i < 4; ++i) code_ = code_ << 8 | next();
    }
    bool get(Chance& chance) noexcept {
        const std::uint32_t bound = (range_ >> 16) * chance.of_zero();
        const bool bit = code_ >= bound;
        if (bit) {
            code_ -= bound;
            range_ -= bound;
        } else {
            range_ = bound;
        }
        chance.learn(bit);
        while (range_ < BinaryEncoder::kLeastRange) {
            range_ <<= 8;
            code_ = code_ << 8 | next();
        }
        return bit;
    }
    /// The zeros that come next, at most so many. What comes after them is not taken.
    std::size_t get_zeros(Chance& chance, std::size_t most) noexcept {
        Chance now = chance;
        std::uint32_t range = range_, code = code_;
        std::size_t count = 0;
        for (; count < most; ++count) {
            const std::uint32_t bound = (range >> 16) * now.of_zero();
            if (code >= bound) break;
            range = bound;
            now.learn(false);
            while (range < BinaryEncoder::kLeastRange) {
                range <<= 8;
                code = code << 8 | next();
            }
        }
        range_ = range;
        code_ = code;
        chance = now;
        return count;
    }
    std::uint32_t get_even(unsigned count) noexcept {
        std::uint32_t bits = 0;
        while (count-- > 0) {
            range_ >>= 1;
            const bool bit = code_ >= range_;
            if (bit) code_ -= range_;
            bits = bits << 1 | static_cast<std::uint32_t>(bit);
            while (range_ < BinaryEncoder::kLeastRange) {
                range_ <<= 8;
                code_ = code_ << 8 | next();
            }
        }
        return bits;
    }
    bool overrun() const noexcept { return beyond_ > 0; }
    bool whole() const noexcept { return beyond_ == 0 && at_ == end_; }

private:
    std::uint32_t next() noexcept {
        if (at_ != end_) return static_cast<unsigned char>(*at_++);
        ++beyond_;
        return 0;
    }

    const char* at_;
    const char* end_;
    std::uint32_t range_ = 0xFFFFFFFFu, code_ = 0;
    std::size_t beyond_ = 0;
};

/// A whole number below 2^50 by its length in bits and the bits below the first: short where small ones are usual (an Elias
/// gamma code whose length, and whose next bit, are learned).
class NumberChances {
public:
    void put(BinaryEncoder& encoder, std::uint64_t number) {
        const std::uint64_t more = number + 1;
        const auto length = static_cast<unsigned>(std::bit_width(more)) - 1;
        for (unsigned i = 0; i < length; ++i) encoder.put(longer_[i], true);
        if (length < kMostLength) encoder.put(longer_[length], false);
        if (length == 0) return;
        encoder.put(second_[length], (more >> (length - 1) & 1u) != 0);
        if (length > 33) encoder.put_even(static_cast<std::uint32_t>(more >> 32), length - 33);
        if (length > 1) encoder.put_even(static_cast<std::uint32_t>(more), std::min(length - 1, 32u));
    }
    std::uint64_t get(BinaryDecoder& decoder) noexcept {
        unsigned length = 0;
        while (length < kMostLength && decoder.get(longer_[length])) ++length;
        if (length == 0) return 0;
        std::uint64_t more = 2 | static_cast<std::uint64_t>(decoder.get(second_[length]));
        if (length > 33) more = more << (length - 33) | decoder.get_even(length - 33);
        if (length > 1) more = more << std::min(length - 1, 32u) | decoder.get_even(std::min(length - 1, 32u));
        return more - 1;
    }

private:
    static constexpr unsigned kMostLength = 50;
    Chance longer_[kMostLength + 1], second_[kMostLength + 1];
};

/// Whole numbers of either sign in turn: 0, -1, 1, -2 ...
constexpr std::uint64_t folded(std::int64_t number) noexcept {
    return number < 0 ? ~(static_cast<std::uint64_t>(number) << 1) : static_cast<std::uint64_t>(number) << 1;
}
constexpr std::int64_t unfolded(std::uint64_t number) noexcept {
    return static_cast<std::int64_t>(number >> 1 ^ (std::uint64_t{0} - (number & 1u)));
}

}  // namespace tactics
