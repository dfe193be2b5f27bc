// SPDX-License-Identifier: Apache-2.0
#include "tactics/coding/container.h"

#include <stdexcept>

#include "tactics/coding/bytes.h"
#include "tactics/error.h"

namespace tactics {

namespace {

constexpr std::uint64_t kVersion = 1;
constexpr std::size_t kIndexEntry = 8, kSumBytes = 4;

}  // namespace

std::string container_bytes(ContainerKind kind, std::string_view facts, std::span<const std::string> parts) {
    std::string bytes(kContainerMagic);
    append_number(bytes, kVersion, 1);
    append_number(bytes, static_cast<std::uint64_t>(kind), 1);
    append_number(bytes, facts.size(), 2);
    append_number(bytes, parts.size(), 4);
    bytes += facts;
    std::size_t size = bytes.size() + kIndexEntry * parts.size() + kSumBytes;
    for (const std::string& part : parts) {
        if (part.size() > UINT32_MAX) throw std::logic_error("a part of 4 GB");
        append_number(bytes, part.size(), 4);
        append_number(bytes, crc32_of(part), 4);
        size += part.size();
    }
    append_number(bytes, crc32_of(bytes), kSumBytes);
    bytes.reserve(size);
    for (const std::string& part : parts) bytes += part;
    return bytes;
}

Container::Container(std::string_view bytes, std::string name) : name_(std::move(name)) {
    ByteReader reader(bytes);
    if (!kContainerMagic.starts_with(reader.take(std::min(bytes.size(), kContainerMagic.size()))))
        throw Error(Fault::failed, name_, phrase("is no .felt file; make one with tactics encode"));
    const std::uint64_t version = reader.number(1), kind = reader.number(1);
    const std::size_t fact_bytes = reader.number(2), count = reader.number(4);
    facts_ = reader.take(fact_bytes);
    if (reader.whole() && version != kVersion)
        throw Error(
            Fault::failed, name_,
            phrase("is a .felt file of version {0}; this program knows version 1, get a newer one", std::to_string(version)));
    if (!reader.whole() || count > reader.left() / kIndexEntry) fail(phrase("it is cut off in its head"));
    parts_.resize(count);
    std::vector<std::size_t> sizes(count);
    for (std::size_t i = 0; i < count; ++i) {
        sizes[i] = reader.number(4);
        parts_[i].sum = static_cast<std::uint32_t>(reader.number(4));
    }
    const std::string_view head = bytes.substr(0, bytes.size() - reader.left());
    const std::uint64_t sum = reader.number(kSumBytes);
    if (!reader.whole()) fail(phrase("it is cut off in its head"));
    if (sum != crc32_of(head)) fail(phrase("its head was changed"));
    if (kind != 1 && kind != 2) fail(phrase("it is of kind {0}, which is not known", std::to_string(kind)));
    kind_ = static_cast<ContainerKind>(kind);
    for (std::size_t i = 0; i < count; ++i) parts_[i].bytes = reader.take(sizes[i]);
    if (!reader.whole()) fail(phrase("it is cut off"));
    if (reader.left() > 0) fail(phrase("something stands behind its end"));
}

std::string_view Container::part(std::size_t number) const {
    const Part& part = parts_.at(number);
    if (crc32_of(part.bytes) != part.sum) fail(phrase("part {0} was changed", std::to_string(number + 1)));
    return part.bytes;
}

void Container::fail(const Phrase& what) const {
    throw Error(Fault::failed, name_, phrase("is damaged: {0}; get a complete copy of it", what));
}

}  // namespace tactics
