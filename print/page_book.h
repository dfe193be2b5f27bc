// SPDX-License-Identifier: Apache-2.0
// One file of many drawings, whose pages come one drawing after the other.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "print/format.h"

namespace tactics {

class PageBook {
public:
    virtual ~PageBook() = default;
    /// The pages of a drawing and of its key, and what an outline calls it: UTF-8, one line; empty: it has no line of its own
    /// there.
    virtual void add(std::span<const Page> pages, const std::string& name) = 0;
    /// The whole file, once, after all; `title` is that of the file. At least one page was added.
    virtual std::string finish(const std::string& title) = 0;
};

/// The most that a book keeps in memory until it is written, in points of lines of 16 bytes: 320 MB.
inline constexpr std::size_t kMostBookPoints = 20'000'000;

/// For a format that holds many pages. A PDF keeps the bytes of its pages only, and has an outline; others keep the pages, and
/// their `add` throws Error(failed) beyond kMostBookPoints.
std::unique_ptr<PageBook> book_of(const Format& format, const Settings& settings);

/// Whether its pages may be of several sizes.
bool holds_several_sizes(const Format& format);

}  // namespace tactics
