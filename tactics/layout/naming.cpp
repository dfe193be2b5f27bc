// SPDX-License-Identifier: Apache-2.0
#include "tactics/layout/naming.h"

#include <limits>
#include <utility>

#include "tactics/error.h"
#include "tactics/layout/naming_try.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

// Words at other places of their things may take the room of other names; so what is left out by that gets letters before them,
// and at last all do.
std::optional<NamedPage> named_yielding(const Page& page, const std::vector<Name>& names, const Sheet& sheet,
                                        std::span<const Rect> windows, double most, Yielding yielding) {
    std::optional<NamedPage> best;
    try {
        best = named_page(page, names, sheet, windows, yielding, most);
    } catch (const Error&) {  // no room for one that must be there
        if (page.regions.empty()) throw;
        for (const Name& name : names) yielding.in_letters.insert(to_line(name.text));
        for (const bool off_thing : {false, true})
            for (const bool all_letters : {off_thing, !off_thing}) {
                yielding.off_thing = off_thing;
                yielding.all_letters = all_letters;
                try {
                    return named_page(page, names, sheet, windows, yielding, most);
                } catch (const Error&) {  // what gives way next may help
                }
            }
        throw;
    }
    if (!best || page.regions.empty()) return best;
    const auto left_out = [&](const NamedPage& made) { return made.page.left_out.size() - page.left_out.size(); };
    for (const bool all : {false, true}) {
        if (left_out(*best) == 0) break;
        const std::vector<Name>& next = all ? names : best->page.left_out;
        for (const Name& name : next) yielding.in_letters.insert(to_line(name.text));
        try {
            auto other = named_page(page, names, sheet, windows, yielding, std::numeric_limits<double>::infinity());
            if (std::pair(left_out(*other), other->cost) < std::pair(left_out(*best), best->cost)) best = std::move(other);
        } catch (const Error&) {  // no room for one that must be there, which the page before has
        }
    }
    if (best->cost >= most) return std::nullopt;
    return best;
}

// Words in several lines may take the room of other names, too.
std::optional<NamedPage> best_named(const Page& page, const std::vector<Name>& names, const Sheet& sheet,
                                    std::span<const Rect> windows, double most) {
    // Of very many names no page has room for all, in whatever lines.
    constexpr std::size_t kMostFolded = 200;
    if (names.size() > kMostFolded) return named_yielding(page, names, sheet, windows, most, {.one_line = true});
    std::optional<NamedPage> best;
    try {
        best = named_yielding(page, names, sheet, windows, most, {});
        if (!best || best->page.left_out.size() == page.left_out.size()) return best;
    } catch (const Error&) {  // in one line each they may have room
    }
    const auto better = [](const NamedPage& a, const NamedPage& b) {
        return std::pair(a.page.left_out.size(), a.cost) < std::pair(b.page.left_out.size(), b.cost);
    };
    try {
        auto other = named_yielding(page, names, sheet, windows, most, {.one_line = true});
        if (!best || (other && better(*other, *best))) best = std::move(other);
    } catch (const Error&) {
        if (!best) throw;
    }
    return best;
}

}  // namespace

std::vector<KeyEntry> set_names(Page& page, const std::vector<Name>& names, const Sheet& sheet, std::span<const Rect> windows) {
    if (names.empty()) return {};
    std::optional<NamedPage> best = best_named(page, names, sheet, windows, std::numeric_limits<double>::infinity());
    page = std::move(best->page);
    return std::move(best->key);
}

std::optional<NamesCost> cost_of_names(const Page& page, const std::vector<Name>& names, const Sheet& sheet,
                                       std::span<const Rect> windows, double most) {
    const std::optional<NamedPage> best = best_named(page, names, sheet, windows, most);
    if (!best) return std::nullopt;
    return NamesCost{best->cost, best->page.left_out.size()};
}

}  // namespace tactics
