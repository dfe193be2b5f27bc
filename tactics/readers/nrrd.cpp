// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/nrrd.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <optional>
#include <string_view>

#include "tactics/error.h"
#include "tactics/readers/gzip.h"
#include "tactics/text/number.h"

namespace tactics {

namespace {

constexpr std::string_view kMagic = "NRRD000";
constexpr std::size_t kMostHead = 64 * 1024;
constexpr double kMostValue = 1e100;          // so that squares of differences are finite
constexpr std::size_t kMostTextOfValue = 32;  // bytes; a double needs 25 with its space

struct Type {
    std::string_view names;  // each between bars
    std::size_t bytes;
    bool has_sign, is_real;
};
constexpr Type kTypes[] = {
    {"|signed char|int8|int8_t|", 1, true, false},
    {"|uchar|unsigned char|uint8|uint8_t|", 1, false, false},
    {"|short|short int|signed short|signed short int|int16|int16_t|", 2, true, false},
    {"|ushort|unsigned short|unsigned short int|uint16|uint16_t|", 2, false, false},
    {"|int|signed int|int32|int32_t|", 4, true, false},
    {"|uint|unsigned int|uint32|uint32_t|", 4, false, false},
    {"|float|", 4, true, true},
    {"|double|", 8, true, true},
};

struct NrrdHead {
    std::string type, sizes, encoding, endian;
    long long dimension = 0, line_skip = 0, byte_skip = 0;
    std::size_t data = 0;  // where it begins
};

std::string_view trimmed(std::string_view text) {
    const auto from = text.find_first_not_of(" \t\r");
    return from == std::string_view::npos ? "" : text.substr(from, text.find_last_not_of(" \t\r") - from + 1);
}

std::vector<std::string_view> words_of(std::string_view text) {
    std::vector<std::string_view> words;
    for (std::size_t at = text.find_first_not_of(" \t\r\n"); at != std::string_view::npos;) {
        const std::size_t end = std::min(text.find_first_of(" \t\r\n", at), text.size());
        words.push_back(text.substr(at, end - at));
        at = text.find_first_not_of(" \t\r\n", end);
    }
    return words;
}

class Nrrd {
public:
    Nrrd(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name), head_(read_head()) {}

    Voxels voxels() const {
        Voxels voxels = shape();
        const Type& type = type_of();
        if (!type.is_real && type.bytes <= 2) {
            voxels.levels = 1 << (8 * type.bytes);
            voxels.lowest = type.has_sign ? -voxels.levels / 2 : 0;
        }
        const auto count = static_cast<std::size_t>(voxels.columns) * static_cast<std::size_t>(voxels.rows) *
                           static_cast<std::size_t>(voxels.slices) * static_cast<std::size_t>(voxels.components);
        const std::string& way = head_.encoding;
        if (head_.line_skip != 0 || head_.byte_skip != 0) fail(phrase("it skips a part of its data, which is not read here"));
        const std::string_view data = bytes_.substr(head_.data);
        if (way == "ascii" || way == "text" || way == "txt") {
            voxels.values = from_text(data, count, type);
        } else if (way == "raw") {
            voxels.values = from_raw(data, count, type);
        } else if (way == "gzip" || way == "gz") {
            voxels.values = from_raw(gunzip(data, count * type.bytes, name_), count, type);
        } else {
            fail(phrase("its encoding is \"{0}\"; raw, ascii and gzip are read", way.substr(0, 40)));
        }
        for (std::size_t i = 0; i < count; ++i)
            if (!(std::abs(voxels.values[i]) < kMostValue))
                fail(phrase("value {0} is not a number, or far too large", std::to_string(i + 1)));
        return voxels;
    }

private:
    [[noreturn]] void fail(const Phrase& what) const { throw Error(Fault::failed, name_, what); }

    std::string_view line_at(std::size_t& at) const {
        const std::size_t end = bytes_.find('\n', at);
        if (end == std::string_view::npos || end > kMostHead) fail(phrase("its head is cut short"));
        const std::string_view line = bytes_.substr(at, end - at);
        at = end + 1;
        return line.substr(0, line.find_last_not_of('\r') + 1);
    }

    NrrdHead read_head() const {
        NrrdHead head;
        std::size_t at = 0;
        line_at(at);
        for (std::string_view line = line_at(at); !line.empty(); line = line_at(at)) {
            const std::size_t colon = line.find(": ");
            if (line[0] == '#' || colon == std::string_view::npos) continue;  // a comment, or key:=value
            const std::string_view field = line.substr(0, colon);
            const std::string value(trimmed(line.substr(colon + 2)));
            if (field == "type") head.type = value;
            if (field == "sizes") head.sizes = value;
            if (field == "encoding") head.encoding = value;
            if (field == "endian") head.endian = value;
            if (field == "dimension") head.dimension = number(value);
            if (field == "line skip" || field == "lineskip") head.line_skip = number(value);
            if (field == "byte skip" || field == "byteskip") head.byte_skip = number(value);
            if (field == "data file" || field == "datafile")
                fail(phrase("its data is in another file; write both into one .nrrd"));
        }
        head.data = at;
        return head;
    }

    long long number(std::string_view text) const {
        const auto value = parse_number(text);
        if (!value || *value != std::floor(*value) || std::abs(*value) > 1e9)
            fail(phrase("\"{0}\" in its head is no whole number", text.substr(0, 40)));
        return static_cast<long long>(*value);
    }

    Voxels shape() const {
        std::vector<long long> sizes;
        for (const std::string_view word : words_of(head_.sizes)) sizes.push_back(number(word));
        if (static_cast<long long>(sizes.size()) != head_.dimension) fail(phrase("it has not as many sizes as dimensions"));
        Voxels voxels;
        if (sizes.size() == 4 && sizes.front() == 3) {
            voxels.components = 3;
            sizes.erase(sizes.begin());
        }
        if (sizes.size() != 3)
            fail(phrase("it is no lattice of numbers or of three components each: 3 dimensions, or 4 of which the first is 3"));
        long long all = voxels.components;
        for (const long long size : sizes) {
            if (size < 1 || size > kMostVoxels || all * size > kMostVoxels)
                fail(phrase("it tells of sizes {0}; 1 to {1} million numbers are read", head_.sizes.substr(0, 80),
                            std::to_string(kMostVoxels / 1'000'000)));
            all *= size;
        }
        voxels.columns = static_cast<int>(sizes[0]);
        voxels.rows = static_cast<int>(sizes[1]);
        voxels.slices = static_cast<int>(sizes[2]);
        return voxels;
    }

    const Type& type_of() const {
        for (const Type& type : kTypes)
            if (!head_.type.empty() && type.names.find("|" + head_.type + "|") != std::string_view::npos) return type;
        fail(phrase("its type is \"{0}\"; whole numbers of up to 32 bits, float and double are read", head_.type.substr(0, 40)));
    }

    // What is written as text may be none of the numbers that the head promises.
    void check_holds(const Type& type, double value, std::size_t number, std::string_view text) const {
        if (type.is_real) return;
        const double all = std::ldexp(1.0, static_cast<int>(8 * type.bytes)), least = type.has_sign ? -all / 2 : 0;
        if (value == std::floor(value) && value >= least && value < least + all) return;
        fail(phrase(
            "value {0} is {1}, and type {2} is whole numbers from {3} to {4}; correct it, or write \"type: float\" in the head",
            std::to_string(number), text, head_.type, to_text(least), to_text(least + all - 1)));
    }

    std::vector<double> from_text(std::string_view text, std::size_t count, const Type& type) const {
        if (count > text.size()) fail(phrase("it is cut short"));
        std::vector<double> values;
        values.reserve(count);
        for (std::size_t at = text.find_first_not_of(" \t\r\n,"); at != std::string_view::npos && values.size() < count;) {
            const std::size_t end = std::min(text.find_first_of(" \t\r\n,", at), text.size());
            const auto value = end - at <= kMostTextOfValue ? parse_number(text.substr(at, end - at)) : std::nullopt;
            if (!value)
                fail(phrase("value {0}, \"{1}\", is not a number", std::to_string(values.size() + 1),
                            text.substr(at, std::min<std::size_t>(end - at, 40))));
            values.push_back(*value);
            check_holds(type, *value, values.size(), text.substr(at, end - at));
            at = text.find_first_not_of(" \t\r\n,", end);
        }
        if (values.size() < count) fail(phrase("it is cut short"));
        return values;
    }

    std::vector<double> from_raw(std::string_view data, std::size_t count, const Type& type) const {
        if (data.size() / type.bytes < count) fail(phrase("it is cut short"));
        const bool big = head_.endian == "big";
        if (type.bytes > 1 && !big && head_.endian != "little") fail(phrase("it does not tell the order of its bytes (endian)"));
        std::vector<double> values(count);
        for (std::size_t i = 0; i < count; ++i) {
            std::uint64_t bits = 0;
            for (std::size_t b = 0; b < type.bytes; ++b) {
                const std::size_t at = i * type.bytes + (big ? b : type.bytes - 1 - b);
                bits = bits << 8 | static_cast<unsigned char>(data[at]);
            }
            values[i] = value_of(bits, type);
        }
        return values;
    }

    static double value_of(std::uint64_t bits, const Type& type) {
        if (type.is_real)
            return type.bytes == 8 ? std::bit_cast<double>(bits)
                                   : static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
        const std::uint64_t sign = std::uint64_t{1} << (8 * type.bytes - 1);
        const auto value = static_cast<double>(bits);
        return type.has_sign && (bits & sign) != 0 ? value - 2 * static_cast<double>(sign) : value;
    }

    std::string_view bytes_;
    const std::string& name_;
    NrrdHead head_;
};

}  // namespace

bool is_nrrd(Source& source) {
    if (source.file == nullptr) return false;
    std::array<char, kMagic.size()> head{};
    std::rewind(source.file.get());
    const std::size_t got = std::fread(head.data(), 1, head.size(), source.file.get());
    std::rewind(source.file.get());
    return std::string_view(head.data(), got) == kMagic;
}

Voxels read_nrrd(Source& source) {
    // No more than the largest that is read.
    constexpr std::size_t kMost = kMostHead + static_cast<std::size_t>(kMostVoxels) * kMostTextOfValue;
    std::string bytes;
    std::rewind(source.file.get());
    for (std::size_t got = 1, step = 1u << 16; got > 0 && bytes.size() < kMost;) {
        const std::size_t before = bytes.size();
        bytes.resize(before + step);
        got = std::fread(bytes.data() + before, 1, step, source.file.get());
        bytes.resize(before + got);
        step = std::min<std::size_t>(2 * step, 16u << 20);
    }
    return Nrrd(bytes, source.name).voxels();
}

}  // namespace tactics
