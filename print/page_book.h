// SPDX-License-Identifier: Apache-2.0
// One file of many drawings, added one after another.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "print/format.h"

namespace tactics {

class PageBook {
public:
    virtual ~PageBook() = default;
    /// Adds the pages of a drawing and of its key, with its entry in the outline: UTF-8, one line; empty: no entry.
    virtual void add(std::span<const Page> pages, const std::string& name) = 0;
    /// The whole file; call it once, after all pages; `title` is that of the file. At least one page must have been added.
    virtual std::string finish(const std::string& title) = 0;
};

/// The most that a book keeps in memory until it is written, in points of 16 bytes: 320 MB.
inline constexpr std::size_t kMostBookPoints = 20'000'000;

/// For a format that holds many pages. A PDF keeps only the bytes of its pages, and has an outline; other formats keep the pages,
/// and their `add` throws Error(failed) beyond kMostBookPoints.
std::unique_ptr<PageBook> book_of(const Format& format, const Settings& settings);

/// Whether its pages may differ in size.
bool holds_several_sizes(const Format& format);

}  // namespace tactics
