// SPDX-License-Identifier: Apache-2.0
#include "print/zip_file.h"

#include <zlib.h>

#include <charconv>
#include <limits>
#include <stdexcept>

#include "print/deflate.h"

namespace tactics {

namespace {

constexpr int kZipLevel = 6;

void append_little(std::string& text, std::uint64_t value, int bytes) {
    for (int i = 0; i < bytes; ++i, value >>= 8) text += static_cast<char>(value & 0xFF);
}

std::uint32_t checksum(std::string_view bytes) {
    return static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

// ZIP uses zlib's format without its two header bytes and the trailing checksum.
std::string packed(std::string_view bytes) {
    std::string all = deflated(bytes, kZipLevel);
    return all.substr(2, all.size() - 6);
}

}  // namespace

// 7 bits for the years since 1980, 4 for the month, 5 for the day.
ZipFile::ZipFile(std::string_view day) {
    const auto number = [&](std::size_t at, std::size_t count) {
        std::uint32_t value = 0;
        std::from_chars(day.data() + at, day.data() + at + count, value);
        return value;
    };
    if (day.size() != 10) throw std::logic_error("a day is written as 2026-03-31");
    day_ = (number(0, 4) - 1980) << 9 | number(5, 2) << 5 | number(8, 2);
}

void ZipFile::add(std::string_view name, std::string_view bytes, Packing packing) {
    const std::string data = packing == Packing::deflated ? packed(bytes) : std::string(bytes);
    constexpr std::size_t kMost = std::numeric_limits<std::uint32_t>::max();
    if (bytes.size() > kMost || bytes_.size() + data.size() + directory_.size() + 1000 > kMost)
        throw std::length_error("a ZIP archive over 4 GiB");
    std::string entry;                                                // what the file's own header and the directory say alike
    append_little(entry, packing == Packing::deflated ? 20 : 10, 2);  // version needed
    append_little(entry, 0x0800, 2);                                  // names are UTF-8
    append_little(entry, packing == Packing::deflated ? 8 : 0, 2);
    append_little(entry, 0, 2);  // time
    append_little(entry, day_, 2);
    append_little(entry, checksum(bytes), 4);
    append_little(entry, data.size(), 4);
    append_little(entry, bytes.size(), 4);
    append_little(entry, name.size(), 2);
    append_little(entry, 0, 2);  // no extra field: EPUB's first entry must have none
    directory_ += "PK\x01\x02";
    append_little(directory_, 20, 2);  // made by
    directory_ += entry;
    append_little(directory_, 0, 2 + 2 + 2 + 4);  // comment, disk, attributes
    append_little(directory_, bytes_.size(), 4);
    directory_ += name;
    bytes_ += "PK\x03\x04";
    bytes_ += entry;
    bytes_ += name;
    bytes_ += data;
    ++count_;
}

std::string ZipFile::finish() {
    const std::size_t start = bytes_.size(), size = directory_.size();
    bytes_ += directory_;
    bytes_ += "PK\x05\x06";
    append_little(bytes_, 0, 4);
    append_little(bytes_, count_, 2);
    append_little(bytes_, count_, 2);
    append_little(bytes_, size, 4);
    append_little(bytes_, start, 4);
    append_little(bytes_, 0, 2);
    return std::move(bytes_);
}

}  // namespace tactics
