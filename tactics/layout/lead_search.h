// SPDX-License-Identifier: Apache-2.0
// Where words may stand away from their thing, with a lead line to it.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "tactics/layout/leads.h"
#include "tactics/layout/room.h"
#include "tactics/page.h"

namespace tactics {

/// A place for words, the lead line from it, and what that costs a hand to follow.
struct Led {
    Rect place;
    Lead lead;
    double cost = 0;  ///< mm
    /// A short one across one line: a better one is not worth looking for.
    bool is_good() const;
};

class LeadSearch {
public:
    LeadSearch(const Page& page, const Medium& medium);

    /// Of a lead line: meeting no line, or crossing some, or other lead lines as well, which is better than no name.
    enum class Way { open, across, anyhow };

    /// A place for words of that size: the nearest of an open way; across lines that with the least cost, where a line less to
    /// cross is worth a longer way. `accept` may refuse places.
    std::optional<Led> led_to(const Room& room, double width, double height, Point end, Way way,
                              const std::function<bool(const Rect&)>& accept);

    std::vector<Point> ends_for(Point thing) const { return leads_.ends_for(thing); }
    bool has_ink_near(Point place, double within) const { return leads_.has_ink_near(place, within); }
    std::size_t crossings(const Lead& lead) const { return leads_.crossings(lead); }

    void add(const Rect& words) { words_.push_back(words); }
    void add(const Lead& lead) { leads_.add(lead); }

private:
    double gap() const;
    bool is_open(const Lead& lead, Way way) const;
    bool meets_words(const Lead& lead) const;

    const Medium& medium_;
    Leads leads_;
    std::vector<Rect> words_;
    std::size_t tried_ = 0;  // lead lines
};

}  // namespace tactics
