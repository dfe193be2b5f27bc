// SPDX-License-Identifier: Apache-2.0
// The container of heights and of recordings: a head, an index and parts, each of which can be read alone.
//
// All numbers have their lowest byte first.
//     0   8   89h "FELT" 0Dh 0Ah 1Ah, which a transfer as text would break
//     8   1   version: 1
//     9   1   kind: 1 heights (level_map.h), 2 a recording (recording.h)
//    10   2   F: bytes of facts
//    12   4   P: parts
//    16   F   facts, of the kind
//     .  8P   the index: of each part its size and its CRC-32, four bytes each
//     .   4   CRC-32 of all before
//     .       the parts, one behind the other; the last ends the file
// Where a part begins follows from the sizes, so that no two can overlap.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/text/phrase.h"

namespace tactics {

inline constexpr std::string_view kContainerMagic{
    "\x89"
    "FELT\r\n\x1a",
    8};

enum class ContainerKind : unsigned char { heights = 1, recording = 2 };

std::string container_bytes(ContainerKind kind, std::string_view facts, std::span<const std::string> parts);

/// One that was opened: what stands in its head was looked through, its parts are as they are in the file.
class Container {
public:
    /// Throws Error(failed) with `name` for bytes that are none, of another version, cut off or changed. `bytes` must outlive it.
    Container(std::string_view bytes, std::string name);

    ContainerKind kind() const noexcept { return kind_; }
    std::string_view facts() const noexcept { return facts_; }
    std::size_t parts() const noexcept { return parts_.size(); }
    /// Throws Error(failed) if its sum is another.
    std::string_view part(std::size_t number) const;
    const std::string& name() const noexcept { return name_; }
    /// Throws Error(failed) that the file is damaged, and how: "the head tells of no rows".
    [[noreturn]] void fail(const Phrase& what) const;

private:
    struct Part {
        std::string_view bytes;
        std::uint32_t sum = 0;
    };
    std::string name_;
    ContainerKind kind_{};
    std::string_view facts_;
    std::vector<Part> parts_;
};

}  // namespace tactics
