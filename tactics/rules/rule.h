// SPDX-License-Identifier: Apache-2.0
// The rules that make a page fit to be felt. Each rule reads a finished page, measures one thing and reports where it is broken;
// its number comes from a published source. Each rule has one file, in the order of list.inc.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/confidence.h"
#include "tactics/medium.h"
#include "tactics/option.h"
#include "tactics/page.h"
#include "tactics/text/phrase.h"

namespace tactics {

struct PageGeometry;

/// A place where a rule is broken.
struct Finding {
    double measured = 0;         ///< in the unit of the rule's limit
    Point at;                    ///< mm on the page
    std::optional<Point> other;  ///< the other side of a gap
    Phrase message;              ///< what is there: "a gap of 1.2 mm between two lines"
    bool whole_page = false;     ///< there is no place; `at` says nothing
};

/// From the top of the page to its bottom.
struct Findings {
    std::vector<Finding> places;
    bool complete = true;  ///< false: there is so much on the page that looking was ended before its end
};

/// A rule stops after this many places; a page that is wrong everywhere needs no longer list.
inline constexpr std::size_t kMostPlaces = 10'000;

/// Files are written in hundredths of a millimetre. What misses a limit by half of one misses it by rounding only.
inline constexpr double kRounding = 0.005;

struct Rule {
    std::string_view name;
    std::string_view summary;  ///< one line, lower case, no period
    SourceWords mend = "";     ///< what to do about it: "move them apart or join them"
    std::string_view source;   ///< who says so
    Confidence confidence = Confidence::uncertain;
    bool hard = false;  ///< a page that breaks it is not fit to be used; otherwise a person should look
    /// Called "least" or "most". Its default is the one for swell paper.
    Option limit;
    /// The limit for a medium; nothing: the rule does not apply to that medium. nullptr: the default, for every medium.
    std::optional<double> (*limit_for)(const Medium& medium) = nullptr;
    Findings (*check)(const PageGeometry& geometry, double limit) = nullptr;
};

/// A measure as a person reads it: to a hundredth.
Phrase shown(double measure);

std::span<const Rule* const> rules();
const Rule* find_rule(std::string_view name);  ///< nullptr if there is none
std::optional<double> limit_of(const Rule& rule, const Medium& medium);

/// A rule and the number that it is to use.
struct Demand {
    const Rule* rule = nullptr;
    double limit = 0;
};
/// All rules about a medium with their own limits.
std::vector<Demand> demands_of(const Medium& medium);

struct Verdict {
    Demand demand;
    Findings findings;
};
/// In the order of the demands. Pure: the same page gives the same verdicts. Time and memory are bounded for any page.
std::vector<Verdict> check_page(const Page& page, std::span<const Demand> demands);

}  // namespace tactics
