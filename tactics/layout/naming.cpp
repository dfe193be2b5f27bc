// SPDX-License-Identifier: Apache-2.0
#include "tactics/layout/naming.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <set>
#include <unordered_map>
#include <utility>

#include "tactics/braille/braille.h"
#include "tactics/error.h"
#include "tactics/geometry/box.h"
#include "tactics/layout/label.h"
#include "tactics/layout/leads.h"
#include "tactics/layout/room.h"
#include "tactics/layout/sheet.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

// A shape within the span of a hand names itself by words beside it; own choice.
constexpr double kLargestShape = 45;  // mm
constexpr double kInMiddle = 0.2;     // of its sides: so near to its middle stands what names it
// Lead lines: 3/4 to 1 1/2 in, the least line there is, no arrowhead (GSTG 3.4.3.5, second-hand; medium confidence).
constexpr double kLongestLead = 38;  // mm
constexpr std::size_t kMostLeads =
    500;  // places examined, the best first; they include all those straight above, below and beside
constexpr std::size_t kMostLeadsOfPage =
    500'000;                         // for all of its names: where 200 found none, thousands more are not looked for in vain
constexpr double kShortestLead = 3;  // mm; own choice: anything shorter is a dot
// Costs for a hand, as settings: a key must be looked up, a lead line followed.
constexpr double kLeftOut = 6, kKeyed = 3, kLed = 1.5;
constexpr double kOnePlace = 0.01;  // mm

struct Piece {
    LabelBlock block;
    Name name;
    std::string key;
};

bool reads_before(const PageName& a, const PageName& b) {
    constexpr double kLine = 10;  // mm: about one line of braille
    const double row_a = std::floor(a.place.top / kLine), row_b = std::floor(b.place.top / kLine);
    return row_a != row_b ? row_a < row_b : a.place.left < b.place.left;
}

double dots_width(std::size_t cells, const Page& page) {
    return (static_cast<double>(cells) - 1) * page.cell.cell_pitch + page.cell.dot_pitch + page.braille_dot;
}

LabelBlock block_of(const std::vector<std::uint8_t>& cells, const Page& page) {
    LabelBlock block;
    block.width = dots_width(cells.size(), page);
    block.height = 2 * page.cell.dot_pitch + page.braille_dot;
    block.braille.push_back({{page.braille_dot / 2, page.braille_dot / 2}, cells});
    return block;
}

LabelBlock block_of(const Name& name, const Sheet& sheet) {
    Sheet quiet = sheet;
    quiet.print_title = sheet.braille_table.empty();  // print between the lines of a drawing is felt as lines
    try {
        return set_label(name.text, quiet);
    } catch (const Error& error) {
        if (name.origin.empty()) throw;
        throw Error(error.fault(), name.origin, error.what());
    }
}

// It keeps `gap` from the words, like all lines: closer, it could be mistaken for a dot (rules/braille_clearance.cpp).
Lead lead_of(const Rect& place, Point thing, double gap) {
    const Point near = nearest_of(place, thing);
    const double far = distance(near, thing);
    const double begin = std::min(1.0, gap / std::max(far, 1e-9));
    return {{near.x + begin * (thing.x - near.x), near.y + begin * (thing.y - near.y)}, thing};
}

// Where a lead line begins.
using Beginning = std::pair<double, double>;
struct BeginningHash {
    std::size_t operator()(const Beginning& at) const {
        return std::hash<double>()(at.first) * 1'000'003 + std::hash<double>()(at.second);
    }
};

class Naming {
public:
    Naming(Page& page, const Sheet& sheet, std::span<const Rect> windows)
        : page_(page),
          sheet_(sheet),
          windows_(windows),
          room_(page, clear_of_braille(*sheet.medium)),
          leads_(page, sheet.medium->thin_line, sheet.medium->gap) {
        for (const BrailleLine& line : page.braille)
            if (!line.cells.empty()) words_.push_back(extent_of(line, page.cell, page.braille_dot));
    }

    // With costs of `most` it goes no further, and the page is not complete.
    std::vector<KeyEntry> run(std::vector<Name> names, double most = std::numeric_limits<double>::infinity()) {
        std::vector<Piece> pieces;
        for (Name& name : names) {
            name.text = to_line(name.text);
            if (name.text.empty()) continue;
            LabelBlock block = block_of(name, sheet_);
            pieces.push_back({std::move(block), std::move(name), ""});
        }
        // Names that must stand close go first, and among these the longest words, for which a place is hardest to find.
        std::stable_sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) {
            return a.name.within != b.name.within ? a.name.within < b.name.within : a.block.width > b.block.width;
        });
        std::vector<Piece> keyed;
        const std::size_t keys = count_of_keys();
        for (Piece& piece : pieces) {
            if (cost_ >= most) return {};
            if (stands_beside(piece) || stands_beside_shape(piece) || stands_apart(piece, Way::open)) continue;
            // Whatever the others find, not all will have a key: of thousands of names each would be looked for in vain.
            if (keyed.size() == keys && !sheet_.braille_table.empty())
                leave_out(piece, phrase("a key"));
            else
                keyed.push_back(std::move(piece));
        }
        std::stable_sort(keyed.begin(), keyed.end(), [](const Piece& a, const Piece& b) { return a.name.text < b.name.text; });
        std::vector<KeyEntry> key;
        if (!keyed.empty()) key = set_key(keyed, most);
        std::stable_sort(page_.names.begin(), page_.names.end(), reads_before);
        return key;
    }

    double cost() const { return cost_; }

private:
    bool stands_beside(Piece& piece) {
        const auto place =
            room_.nearest(piece.name.at, piece.block.width, piece.block.height, std::max(kBesideThing, piece.name.within),
                          [this](const Rect& rect) { return is_whole(rect); });
        if (!place) return false;
        put(piece, *place);
        return true;
    }

    // Words that a box has no room for stand right beside the box.
    bool stands_beside_shape(Piece& piece) {
        const auto shape = smallest_around(piece.name.at);
        if (!shape) return false;
        const Box near = grown(*shape, kBesideThing);
        const auto place = room_.nearest(
            piece.name.at, piece.block.width, piece.block.height, std::hypot(shape->width(), shape->height()) / 2 + kBesideThing,
            [&](const Rect& rect) { return is_whole(rect) && meet(box_of(rect), near) && !meet(box_of(rect), *shape); });
        if (!place) return false;
        put(piece, *place);
        return true;
    }

    // The smallest closed line around a place, if a hand feels it as one thing.
    std::optional<Box> smallest_around(Point at) const {
        std::optional<Box> best;
        for (const PageStroke& stroke : page_.strokes) {
            if (!stroke.closed || stroke.points.size() < 3) continue;
            const Box box = box_of(stroke.points);
            if (!box.holds(at) || std::max(box.width(), box.height()) > kLargestShape) continue;
            const Point middle{(box.left + box.right) / 2, (box.top + box.bottom) / 2};
            if (std::abs(at.x - middle.x) > kInMiddle * box.width() || std::abs(at.y - middle.y) > kInMiddle * box.height())
                continue;
            if (!best || box.width() * box.height() < best->width() * best->height()) best = box;
        }
        return best;
    }

    enum class Way { open, across };  // of a lead line: meeting no line, or crossing some, which is better than no name

    bool stands_apart(Piece& piece, Way way) {
        if (leads_tried_ >= kMostLeadsOfPage) return false;
        if (!page_.live.holds(piece.name.at)) return false;  // print beside a large drawing
        const auto ends = leads_.ends_for(piece.name.at);
        return std::any_of(ends.begin(), ends.end(), [&](Point end) { return is_led_to(piece, end, way); });
    }

    bool is_led_to(Piece& piece, Point end, Way way) {
        const double gap = lead_gap();
        // Many places share a lead line: words above a thing may stand farther left or right.
        std::unordered_map<Beginning, bool, BeginningHash> known;
        const auto leads_there = [&](const Rect& rect) {
            if (!is_whole(rect)) return false;
            const Lead lead = lead_of(rect, end, gap);
            const Beginning begins{lead.from.x, lead.from.y};
            if (const auto same = known.find(begins); same != known.end()) return same->second;
            if (known.size() >= kMostLeads || leads_tried_ >= kMostLeadsOfPage) return false;
            ++leads_tried_;
            const double length = distance(lead.from, lead.to);
            return known[begins] = length <= kLongestLead && length >= kShortestLead && !meets_words(lead) &&
                                   leads_.is_clear(lead, way == Way::across);
        };
        const auto place = room_.nearest(end, piece.block.width, piece.block.height, kLongestLead + gap, leads_there);
        if (!place) return false;
        put(piece, *place);
        const Lead lead = lead_of(*place, end, gap);
        page_.strokes.push_back({{lead.from, lead.to}, false, sheet_.medium->thin_line, Role::lead});
        room_.take(lead.from, lead.to, sheet_.medium->thin_line);
        leads_.add(lead);
        return true;
    }

    // From the middle of a lead line to words; files round to hundredths, at both.
    double lead_gap() const { return clear_of_braille(*sheet_.medium) + sheet_.medium->thin_line / 2 + 0.02; }

    // Where the place that it has is hemmed in: another one on the border of the same thing.
    bool stands_elsewhere(Piece& piece) {
        constexpr std::size_t kMostPlaces = 48;         // of a thing
        constexpr std::size_t kMostPlacesOfPage = 400;  // where many have no room, more are looked for in vain
        if (places_tried_ >= kMostPlacesOfPage) return false;
        const Region* thing = nullptr;
        double least = 0;
        for (const Region& region : page_.regions) {
            if (!holds(region, piece.name.at)) continue;
            const Box box = box_of(region);
            if (thing != nullptr && box.width() * box.height() >= least) continue;
            thing = &region;
            least = box.width() * box.height();
        }
        if (thing == nullptr) return false;
        std::vector<Point> places;
        for (const auto& ring : thing->rings)
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const Point next = ring[(i + 1) % ring.size()];
                places.push_back(ring[i]);
                places.push_back({(ring[i].x + next.x) / 2, (ring[i].y + next.y) / 2});
            }
        const std::size_t step = 1 + places.size() / kMostPlaces;
        for (std::size_t i = 0; i < places.size(); i += step) {
            piece.name.at = places[i];
            ++places_tried_;
            if (stands_beside(piece) || stands_apart(piece, Way::across)) return true;
        }
        return false;
    }

    // On one sheet.
    bool is_whole(const Rect& rect) const {
        return windows_.empty() || std::any_of(windows_.begin(), windows_.end(), [&](const Rect& window) {
                   return rect.left >= window.left && rect.top >= window.top &&
                          rect.left + rect.width <= window.left + window.width &&
                          rect.top + rect.height <= window.top + window.height;
               });
    }

    // A line beside other words seems to belong to them.
    bool meets_words(const Lead& lead) const {
        constexpr double kStep = 0.25;  // mm
        const int steps = 1 + static_cast<int>(distance(lead.from, lead.to) / kStep);
        const double least = lead_gap() - 1e-6;
        const Box around = grown(box_of(std::array{lead.from, lead.to}), lead_gap());
        return std::any_of(words_.begin(), words_.end(), [&](const Rect& words) {
            if (!meet(around, box_of(words))) return false;
            for (int i = 0; i <= steps; ++i) {
                const double t = static_cast<double>(i) / steps;
                const Point p{lead.from.x + t * (lead.to.x - lead.from.x), lead.from.y + t * (lead.to.y - lead.from.y)};
                if (distance(nearest_of(words, p), p) < least) return true;
            }
            return false;
        });
    }

    void put(const Piece& piece, const Rect& place) {
        room_.take(place);
        words_.push_back(place);
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
        for (PrintLine& line : block.print) {
            line.baseline.x += place.left;
            line.baseline.y += place.top;
        }
        for (BrailleLine& line : block.braille) {
            line.first_dot.x += place.left;
            line.first_dot.y += place.top;
        }
        std::move(block.print.begin(), block.print.end(), std::back_inserter(page_.print));
        std::move(block.braille.begin(), block.braille.end(), std::back_inserter(page_.braille));
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

    // The key, if it has no room.
    std::vector<KeyEntry> set_key(std::vector<Piece>& keyed, double most) {
        // Print has no two letters: it is small, and a sheet without braille is for eyes.
        if (sheet_.braille_table.empty()) {
            for (const Piece& piece : keyed) leave_out(piece, phrase("the words"));
            return {};
        }
        std::set<std::string> taken;
        std::vector<KeyEntry> key;
        std::size_t longest = 0;
        for (Piece& piece : keyed) {
            if (cost_ >= most) return {};
            piece.key = key_for(piece.name.text, taken);
            if (piece.key.empty()) {
                leave_out(piece, phrase("a key"));
                continue;
            }
            taken.insert(piece.key);
            std::vector<std::uint8_t> cells{letter_cell(piece.key[0]), letter_cell(piece.key[1])};
            Piece letters = piece;
            letters.block = block_of(cells, page_);
            if (!stands_beside(letters) && !stands_apart(letters, Way::open) && !stands_apart(letters, Way::across) &&
                !stands_elsewhere(letters)) {
                leave_out(piece, phrase("the words and even for two letters"));
                continue;
            }
            cells.resize(kWordsFrom, 0);
            const auto& words = piece.block.braille.front().cells;
            cells.insert(cells.end(), words.begin(), words.end());
            longest = std::max(longest, cells.size());
            key.push_back({piece.key, piece.name.text, std::move(cells)});
        }
        if (key.empty()) return {};
        const double width = dots_width(longest, page_);
        const double last = 2 * page_.cell.dot_pitch + page_.braille_dot;
        const double height = static_cast<double>(key.size() - 1) * page_.cell.line_pitch + last;
        const auto place = room_.lowest(width, height, [this](const Rect& rect) { return is_whole(rect); });
        const int first = static_cast<int>(page_.words.size());
        for (const KeyEntry& entry : key) page_.words.push_back({WordsKind::key, entry.text, entry.letters});
        if (!place) return key;
        for (std::size_t i = 0; i < key.size(); ++i)
            page_.braille.push_back({{place->left + page_.braille_dot / 2,
                                      place->top + page_.braille_dot / 2 + static_cast<double>(i) * page_.cell.line_pitch},
                                     std::move(key[i].cells),
                                     first + static_cast<int>(i)});
        return {};
    }

    Page& page_;
    const Sheet& sheet_;
    std::span<const Rect> windows_;
    Room room_;
    Leads leads_;
    std::size_t leads_tried_ = 0, places_tried_ = 0;
    double cost_ = 0;
    std::vector<Rect> words_;
};

}  // namespace

std::vector<KeyEntry> set_names(Page& page, std::vector<Name> names, const Sheet& sheet, std::span<const Rect> windows) {
    if (names.empty()) return {};
    return Naming(page, sheet, windows).run(std::move(names));
}

std::optional<NamesCost> cost_of_names(Page page, std::vector<Name> names, const Sheet& sheet, std::span<const Rect> windows,
                                       double most) {
    Naming naming(page, sheet, windows);
    naming.run(std::move(names), most);
    if (naming.cost() >= most) return std::nullopt;
    return NamesCost{naming.cost(), page.left_out.size()};
}

}  // namespace tactics
