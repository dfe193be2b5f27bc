// SPDX-License-Identifier: Apache-2.0
// Which element of an SVG drew what of a page.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tactics/readers/svg/found_page.h"
#include "tactics/readers/svg/transform.h"
#include "tactics/readers/xml.h"

namespace tactics {

/// How much there is on a page so far.
struct PageCounts {
    std::size_t strokes = 0, areas = 0, textured = 0, regions = 0, braille = 0, pictures = 0;
    bool operator==(const PageCounts&) const = default;
};

struct FoundMark {
    const Element* element = nullptr;
    Transform transform;        ///< from its units to mm
    std::string_view layer;     ///< of our own files; empty: it is in none
    PageCounts before, behind;  ///< what lies between is its
};

/// Adds the mark of an element when it has been drawn, if anything was.
class MarkKeeper {
public:
    MarkKeeper(std::vector<FoundMark>* marks, const Element& element, const Transform& transform, std::string_view layer,
               const Page& page)
        : marks_(marks), page_(page) {
        if (marks != nullptr) mark_ = {&element, transform, layer, counts(), {}};
    }
    ~MarkKeeper() {
        if (marks_ == nullptr) return;
        mark_.behind = counts();
        if (mark_.behind == mark_.before) return;
        marks_->push_back(mark_);
    }
    MarkKeeper(const MarkKeeper&) = delete;
    MarkKeeper& operator=(const MarkKeeper&) = delete;

private:
    PageCounts counts() const {
        return {page_.strokes.size(), page_.areas.size(),   page_.textured.size(),
                page_.regions.size(), page_.braille.size(), page_.picture ? 1u : 0u};
    }

    std::vector<FoundMark>* marks_;
    const Page& page_;
    FoundMark mark_;
};

/// read_svg of a page, with the marks of its elements, which `root` must outlive.
FoundPage read_marked_svg(const Element& root, const std::string& file, std::vector<FoundMark>& marks);

}  // namespace tactics
