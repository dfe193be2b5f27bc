// SPDX-License-Identifier: Apache-2.0
#include "tactics/layout/naming_try.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "tactics/braille/braille.h"
#include "tactics/error.h"
#include "tactics/geometry/box.h"
#include "tactics/layout/label.h"
#include "tactics/layout/lead_search.h"
#include "tactics/layout/name_blocks.h"
#include "tactics/layout/naming.h"
#include "tactics/layout/room.h"
#include "tactics/layout/sheet.h"
#include "tactics/layout/thing_places.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

// Costs for a hand, as settings: a key must be looked up, a lead line followed.
constexpr double kLeftOut = 6, kKeyed = 3, kLed = 1.5, kCrossed = 0.1;
constexpr std::size_t kMostPlaces = 16;         // of a thing
constexpr std::size_t kMostOfAll = 48;          // where none of them has room
constexpr std::size_t kMostPlacesOfPage = 400;  // where many have no room, more are looked for in vain
constexpr std::size_t kMostLines = 3;           // of a name beside its thing
constexpr double kOnePlace = 0.01;              // mm

struct Piece {
    LabelBlock block;
    Name name;
    const Region* thing;  // that it names; null: none that is told apart
    std::string key = {};
};

using Way = LeadSearch::Way;

class Naming {
public:
    Naming(Page& page, const Sheet& sheet, std::span<const Rect> windows, const Yielding& yielding)
        : yielding_(yielding),
          page_(page),
          sheet_(sheet),
          windows_(windows),
          room_(page, clear_of_braille(*sheet.medium)),
          leads_(page, *sheet.medium),
          things_(page.regions, page.language),
          shapes_(page) {
        for (const BrailleLine& line : page.braille)
            if (!line.cells.empty()) leads_.add(extent_of(line, page.cell, page.braille_dot));
    }

    // With costs of `most` it goes no further, and the page is not complete.
    std::vector<KeyEntry> run(std::vector<Name> names, double most = std::numeric_limits<double>::infinity()) {
        std::vector<Piece> pieces;
        for (Name& name : names) {
            name.text = to_line(name.text);
            if (name.text.empty()) continue;
            LabelBlock block = block_of(name, sheet_);
            const Region* thing = things_.thing_of(name.text, name.at);
            pieces.push_back({std::move(block), std::move(name), thing});
        }
        // Names that must stand close go first, and among these the longest words, for which a place is hardest to find.
        std::stable_sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) {
            return a.name.within != b.name.within ? a.name.within < b.name.within : a.block.width > b.block.width;
        });
        std::vector<Piece> first, keyed, waiting;
        const std::size_t keys = count_of_keys();
        for (Piece& piece : pieces) {
            if (cost_ >= most) return {};
            if (yielding_.all_letters && !piece.name.optional)
                first.push_back(std::move(piece));
            else if (!stands_beside(piece) && !stands_folded(piece) && !stands_beside_shape(piece) &&
                     !stands_apart(piece, piece.thing == nullptr))
                (yielding_.in_letters.contains(piece.name.text) ? first : waiting).push_back(std::move(piece));
        }
        set_letters(first, most);
        for (Piece& piece : waiting) {
            if (cost_ >= most) return {};
            if (piece.thing != nullptr && (stands_elsewhere(piece) || stands_apart(piece, true))) continue;
            // Whatever the others find, not all will have a key: of thousands of names each would be looked for in vain.
            if (keyed.size() == keys && !sheet_.braille_table.empty())
                leave_out(piece, phrase("a key"));
            else
                keyed.push_back(std::move(piece));
        }
        set_letters(keyed, most);
        if (cost_ >= most) return {};
        std::vector<KeyEntry> left = set_key();
        sort_as_read(page_.names);
        return left;
    }

    double cost() const { return cost_; }

private:
    bool stands_beside(Piece& piece) {
        return stands_beside(piece, [&](const Rect& rect) { return may_stand(piece, rect); });
    }

    template <typename Accept>
    bool stands_beside(Piece& piece, Accept accept) {
        const auto place = room_.nearest(piece.name.at, piece.block.width, piece.block.height,
                                         std::max(kBesideThing, piece.name.within), accept);
        if (!place) return false;
        put(piece, *place);
        return true;
    }

    // In lines one below the other, where one line is too long.
    bool stands_folded(Piece& piece) {
        if (yielding_.one_line) return false;
        for (LabelBlock& block : folded(piece.block, kMostLines, page_)) {
            std::swap(piece.block, block);
            if (stands_beside(piece)) return true;
            std::swap(piece.block, block);
        }
        return false;
    }

    // Words that a box has no room for stand right beside the box.
    bool stands_beside_shape(Piece& piece) {
        const auto shape = shape_around(page_, piece.name.at);
        if (!shape) return false;
        const Box near = grown(*shape, kBesideThing);
        const auto place = room_.nearest(
            piece.name.at, piece.block.width, piece.block.height, std::hypot(shape->width(), shape->height()) / 2 + kBesideThing,
            [&](const Rect& rect) { return may_stand(piece, rect) && meet(box_of(rect), near) && !meet(box_of(rect), *shape); });
        if (!place) return false;
        put(piece, *place);
        return true;
    }

    // Inside a thing, or wherever something without regions is. Ink beside it may be the border of something else, too.
    bool stands_apart(Piece& piece, bool on_ink) {
        if (!page_.live.holds(piece.name.at)) return false;  // print beside a large drawing
        for (const Point end : leads_.ends_for(piece.name.at))
            if ((on_ink || distance(end, piece.name.at) < kOnePlace) && is_led_to(piece, end)) return true;
        return false;
    }

    bool is_led_to(Piece& piece, Point end) {
        const auto led = led_to(piece, end, Way::open);
        if (led) put_led(piece, *led);
        return led.has_value();
    }

    std::optional<Led> led_to(const Piece& piece, Point end, Way way) {
        return leads_.led_to(room_, piece.block.width, piece.block.height, end, way,
                             [&](const Rect& rect) { return may_stand(piece, rect); });
    }

    void put_led(const Piece& piece, const Led& led) {
        put(piece, led.place);
        cost_ += kCrossed * static_cast<double>(leads_.crossings(led.lead));
        page_.strokes.push_back({{led.lead.from, led.lead.to}, false, sheet_.medium->thin_line, Role::lead});
        room_.take(led.lead.from, led.lead.to, sheet_.medium->thin_line);
        leads_.add(led.lead);
    }

    // Where the place that it has is hemmed in: other ones on the border of the same thing, and what ink is there.
    std::vector<std::pair<Point, Point>> elsewhere(const Piece& piece, ThingPlaces::Border border) {
        constexpr double kDrawn = 1;  // mm: where it is hidden, its border has no line
        if (piece.thing == nullptr || places_tried_ >= kMostPlacesOfPage) return {};
        std::vector<std::pair<Point, Point>> places;
        for (const Point at : things_.on_border(*piece.thing, piece.name.at, border,
                                                border == ThingPlaces::Border::own ? kMostPlaces : kMostOfAll))
            if (const Point end = leads_.ends_for(at).front(); leads_.has_ink_near(at, kDrawn)) places.push_back({at, end});
        return places;
    }

    bool stands_elsewhere(Piece& piece) {
        const auto is_of_it = [&](const Rect& rect) {
            return may_stand(piece, rect) && things_.is_free_of_others(*piece.thing, rect.middle());
        };
        const Point before = piece.name.at;
        for (const auto& [place, end] : elsewhere(piece, ThingPlaces::Border::own)) {
            piece.name.at = place;
            ++places_tried_;
            if (stands_beside(piece, is_of_it) || is_led_to(piece, end)) return true;
        }
        piece.name.at = before;
        return false;
    }

    // Across as few lines as it can, by as short a line.
    bool stands_across(Piece& piece, ThingPlaces::Border border, Way way) {
        std::optional<Led> best;
        Point at = piece.name.at;
        const auto compare = [&](Point place, Point end) {
            if (best && (best->is_good() || page_.regions.empty())) return;  // of what has no extent, ends are much the same
            if (const auto led = led_to(piece, end, way); led && (!best || led->cost < best->cost)) {
                best = led;
                at = place;
            }
        };
        if (page_.live.holds(piece.name.at))
            for (const Point end : leads_.ends_for(piece.name.at))
                if (border == ThingPlaces::Border::any || distance(end, piece.name.at) < kOnePlace) compare(piece.name.at, end);
        for (const auto& [place, end] : elsewhere(piece, border)) {
            ++places_tried_;
            compare(place, end);
        }
        if (!best) return false;
        piece.name.at = at;
        put_led(piece, *best);
        return true;
    }

    // Not within the box of something else.
    bool may_stand(const Piece& piece, const Rect& rect) const {
        return is_whole(rect) && !shapes_.any_around_only(rect.middle(), piece.name.at);
    }

    // On one sheet.
    bool is_whole(const Rect& rect) const {
        return windows_.empty() || std::any_of(windows_.begin(), windows_.end(), [&](const Rect& window) {
                   return rect.left >= window.left && rect.top >= window.top &&
                          rect.left + rect.width <= window.left + window.width &&
                          rect.top + rect.height <= window.top + window.height;
               });
    }

    void put(const Piece& piece, const Rect& place) {
        room_.take(place);
        leads_.add(place);
        LabelBlock block = piece.block;
        const bool words = piece.key.empty();
        say(block, page_,
            {words ? WordsKind::name : WordsKind::letters,
             piece.name.text,
             piece.key,
             {},
             0,
             0,
             piece.name.within,
             piece.name.optional});
        put_on(page_, std::move(block), {place.left, place.top});
        page_.names.push_back({piece.name.text, piece.key, piece.name.at, place, static_cast<int>(page_.words.size()) - 1});
        if (!words)
            cost_ += kKeyed;
        else if (distance(nearest_of(place, piece.name.at), piece.name.at) > kBesideThing + kOnePlace)
            cost_ += kLed;  // with or without a lead line
    }

    void leave_out(const Piece& piece, const Phrase& what) {
        if (piece.name.optional) {
            cost_ += kLeftOut;
            page_.left_out.push_back(piece.name);
            return;
        }
        throw Error(Fault::usage, piece.name.origin,
                    phrase("there is no room for {0} of \"{1}\" clear of the lines; take larger paper, fewer lines ({2} 0.5), or "
                           "fewer names",
                           what, beginning_of(piece.name.text), spelled("detail")));
    }

    // For two letters, the ways that are easiest to follow first.
    bool find_room(Piece& letters) {
        using Border = ThingPlaces::Border;
        const bool is_of_thing = letters.thing != nullptr;
        return stands_beside(letters) || (is_of_thing && stands_apart(letters, false)) || stands_elsewhere(letters) ||
               stands_apart(letters, true) || (is_of_thing && stands_across(letters, Border::own, Way::across)) ||
               stands_across(letters, Border::any, Way::anyhow) || stands_off_thing(letters);
    }

    bool stands_off_thing(Piece& letters) {
        if (!yielding_.off_thing || letters.name.optional || letters.thing != nullptr) return false;
        letters.thing = things_.thing_at(letters.name.at);
        return letters.thing != nullptr &&
               (stands_elsewhere(letters) || stands_across(letters, ThingPlaces::Border::any, Way::anyhow));
    }

    void set_letters(std::vector<Piece>& keyed, double most) {
        places_tried_ = 0;  // letters find room where words did not
        std::stable_sort(keyed.begin(), keyed.end(), [](const Piece& a, const Piece& b) {
            return a.name.optional != b.name.optional ? b.name.optional : a.name.text < b.name.text;
        });
        for (Piece& piece : keyed) {
            // Print has no two letters: it is small, and a sheet without braille is for eyes.
            if (sheet_.braille_table.empty()) {
                leave_out(piece, phrase("the words"));
                continue;
            }
            if (cost_ >= most) return;
            const auto known =
                std::find_if(key_.begin(), key_.end(), [&](const KeyEntry& entry) { return entry.text == piece.name.text; });
            piece.key = known != key_.end() ? known->letters : key_for(piece.name.text, taken_);
            if (piece.key.empty()) {
                leave_out(piece, phrase("a key"));
                continue;
            }
            taken_.insert(piece.key);
            std::vector<std::uint8_t> cells{letter_cell(piece.key[0]), letter_cell(piece.key[1])};
            Piece letters = piece;
            letters.block = block_of(cells, page_);
            if (!find_room(letters)) {
                leave_out(piece, phrase("the words and even for two letters"));
                continue;
            }
            if (known != key_.end()) continue;
            cells.resize(kWordsFrom, 0);
            const auto& words = piece.block.braille.front().cells;
            cells.insert(cells.end(), words.begin(), words.end());
            key_.push_back({piece.key, piece.name.text, std::move(cells)});
        }
    }

    // The key, if it has no room.
    std::vector<KeyEntry> set_key() {
        std::vector<KeyEntry>& key = key_;
        if (key.empty()) return {};
        std::stable_sort(key.begin(), key.end(), [](const KeyEntry& a, const KeyEntry& b) { return a.text < b.text; });
        std::size_t longest = 0;
        for (const KeyEntry& entry : key) longest = std::max(longest, entry.cells.size());
        const double width = dots_width(longest, page_);
        const double last = 2 * page_.cell.dot_pitch + page_.braille_dot;
        const double height = static_cast<double>(key.size() - 1) * page_.cell.line_pitch + last;
        const auto place = room_.lowest(width, height, [this](const Rect& rect) { return is_whole(rect); });
        const int first = static_cast<int>(page_.words.size());
        for (const KeyEntry& entry : key) page_.words.push_back({WordsKind::key, entry.text, entry.letters});
        if (!place) return std::move(key_);
        for (std::size_t i = 0; i < key.size(); ++i)
            page_.braille.push_back({{place->left + page_.braille_dot / 2,
                                      place->top + page_.braille_dot / 2 + static_cast<double>(i) * page_.cell.line_pitch},
                                     std::move(key[i].cells),
                                     first + static_cast<int>(i)});
        return {};
    }

    const Yielding& yielding_;
    Page& page_;
    const Sheet& sheet_;
    std::span<const Rect> windows_;
    Room room_;
    LeadSearch leads_;
    ThingPlaces things_;
    ClosedShapes shapes_;
    std::size_t places_tried_ = 0;
    double cost_ = 0;
    std::set<std::string> taken_;  // keys
    std::vector<KeyEntry> key_;
};

}  // namespace

std::optional<NamedPage> named_page(const Page& page, const std::vector<Name>& names, const Sheet& sheet,
                                    std::span<const Rect> windows, const Yielding& yielding, double most) {
    NamedPage made{page, {}, 0};
    Naming naming(made.page, sheet, windows, yielding);
    made.key = naming.run(names, most);
    made.cost = naming.cost();
    if (made.cost >= most) return std::nullopt;
    return made;
}

}  // namespace tactics
