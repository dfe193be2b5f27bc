// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/room_for_names.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "tactics/error.h"
#include "tactics/layout/label.h"
#include "tactics/layout/lay_out.h"
#include "tactics/layout/room.h"

namespace tactics {

namespace {

constexpr double kTenthSmaller = 1;  // a drawing smaller by a tenth is less bad than one lead line
constexpr std::array<double, 5> kShares{1, 0.9, 0.8, 0.7, 0.6};
constexpr std::size_t kHopeless = 100;  // names left out on a page: no other width has room for so many. A setting
constexpr double kSmallest = 0.4;       // of the widest: where names beside it would leave less, they have leads or a key

double cost_of_size(double share) { return kTenthSmaller * 10 * (1 - share); }

// How far names reach out of a drawing.
struct Beside {
    double left = 0, top = 0, right = 0, bottom = 0;  // mm
};

struct Block {
    double width = 0, height = 0;
};

std::vector<Block> blocks_of(const std::vector<Name>& names, const Sheet& sheet) {
    Sheet quiet = sheet;
    quiet.print_title = sheet.braille_table.empty();  // as set_names sets them
    std::vector<Block> blocks;
    for (const Name& name : names) {
        const LabelBlock block = set_label(name.text, quiet);
        blocks.push_back({block.width, block.height});
    }
    return blocks;
}

// A name is beside the drawing on the side where it is farther out, clear of what is drawn, with its middle where the print has
// it if that leaves it clear.
Beside beside(const std::vector<Name>& names, const std::vector<Block>& blocks, double width, double height, double clear) {
    Beside most;
    const auto take = [](double& side, double reach) { side = std::max(side, reach); };
    for (std::size_t i = 0; i < names.size(); ++i) {
        const Point at = names[i].at;
        const double left = -at.x, right = at.x - width, top = -at.y, bottom = at.y - height;
        const double across = std::max({left, right, 0.0}), down = std::max({top, bottom, 0.0});
        if (across == 0 && down == 0) continue;
        const double half_width = blocks[i].width / 2, half_height = blocks[i].height / 2;
        if (down >= across) {
            take(top > 0 ? most.top : most.bottom, std::max(down, clear + half_height) + half_height);
            if (names[i].within > 0) continue;  // it may stand farther left or right
            take(most.left, half_width + left);
            take(most.right, half_width + right);
        } else {
            take(left > 0 ? most.left : most.right, std::max(across, clear + half_width) + half_width);
            take(most.top, half_height + top);
            take(most.bottom, half_height + bottom);
        }
    }
    return most;
}

// One way up of a sheet.
class Upright {
public:
    Upright(const Sheet& sheet, Orientation orientation, double aspect, const std::vector<Block>& blocks,
            const SizedDrawing& drawing)
        : sheet_(sheet), aspect_(aspect), blocks_(blocks), drawing_(drawing) {
        sheet_.orientation = orientation;
        const Arrangement whole = arrange(sheet_, aspect);
        widest_ = whole.place.drawing.width;
        const Rect& live = whole.place.live;
        room_ = {live.left, live.top + whole.band.height, live.width, live.height - whole.band.height - whole.scale_bar.height};
    }

    double widest() const { return widest_; }

    // Beside which all names have room; or nothing.
    std::optional<double> width_for_names() const {
        if (fits(widest_)) return widest_;
        double fitting = kSmallest * widest_, not_fitting = widest_;
        if (!fits(fitting)) return std::nullopt;
        constexpr int kHalvings = 8;
        for (int i = 0; i < kHalvings; ++i) {
            const double middle = (fitting + not_fitting) / 2;
            (fits(middle) ? fitting : not_fitting) = middle;
        }
        return fitting;
    }

    // The drawing stands where the names beside it have room, or equally little. Free room is below it.
    Arrangement with(double width) const {
        Sheet sized = sheet_;
        if (width < widest_) sized.drawing_width = width;
        Arrangement arrangement = arrange(sized, aspect_);
        Rect& place = arrangement.place.drawing;
        const Beside names = beside_at(place.width);
        const auto before = [](double spare, double first, double last) {
            const double both = first + last;
            return both <= spare ? first + (spare - both) / 2 : both > 0 ? spare * first / both : 0;
        };
        const double below = room_.height - place.height;
        place.left = room_.left + before(room_.width - place.width, names.left, names.right);
        place.top = room_.top + std::min(names.top, before(below, names.top, names.bottom));
        return arrangement;
    }

    const Sheet& sheet() const { return sheet_; }

private:
    Beside beside_at(double width) const {
        return beside(drawing_.names(width), blocks_, width, width / aspect_, clear_of_braille(*sheet_.medium));
    }

    bool fits(double width) const {
        const Beside names = beside_at(width);
        return names.left + width + names.right <= room_.width && names.top + width / aspect_ + names.bottom <= room_.height;
    }

    Sheet sheet_;
    double aspect_;
    const std::vector<Block>& blocks_;
    const SizedDrawing& drawing_;
    double widest_ = 0;
    Rect room_;
};

std::vector<Upright> ways_up(const Sheet& sheet, double aspect, const std::vector<Block>& blocks, const SizedDrawing& drawing) {
    std::vector<Upright> ways;
    for (const Orientation orientation : {Orientation::portrait, Orientation::landscape}) {
        if (sheet.orientation != Orientation::automatic && sheet.orientation != orientation) continue;
        try {
            ways.emplace_back(sheet, orientation, aspect, blocks, drawing);
        } catch (const Error&) {
            continue;  // such as a title that has no room
        }
    }
    return ways;
}

struct Trial {
    const Upright* way;
    double width;
};

// The most promising first: where names have room beside the drawing, and the larger drawing.
std::vector<Trial> trials_of(const std::vector<Upright>& ways) {
    std::vector<Trial> trials, others;
    for (const Upright& way : ways) {
        if (const auto width = way.width_for_names()) trials.push_back({&way, *width});
        for (const double share : kShares) others.push_back({&way, share * way.widest()});
    }
    const auto wider = [](const Trial& a, const Trial& b) { return a.width > b.width; };
    std::stable_sort(trials.begin(), trials.end(), wider);
    std::stable_sort(others.begin(), others.end(), wider);
    trials.insert(trials.end(), others.begin(), others.end());
    return trials;
}

}  // namespace

std::optional<RoomFound> place_with_room(const Sheet& sheet, double aspect, const SizedDrawing& drawing) {
    const std::vector<Block> blocks = blocks_of(drawing.names(1), sheet);
    const std::vector<Upright> ways = ways_up(sheet, aspect, blocks, drawing);
    double widest = 0;
    for (const Upright& way : ways) widest = std::max(widest, way.widest());
    std::optional<RoomFound> best;
    double least = 0;
    for (const Trial& trial : trials_of(ways)) {
        const double smaller = cost_of_size(trial.width / widest);
        if (best && smaller >= least) continue;  // it cannot be better
        try {
            const Arrangement arrangement = trial.way->with(trial.width);
            // A little more, for what rounds otherwise than below.
            const double most = best ? least - smaller + 1e-9 : std::numeric_limits<double>::infinity();
            const auto names = cost_of_names(drawing.draw(trial.width), trial.way->sheet(), arrangement, most);
            if (!names || (best && names->cost + smaller >= least)) continue;
            best = {arrangement, names->left_out};
            least = names->cost + smaller;
            if (names->left_out > kHopeless) break;
        } catch (const Error&) {
            continue;  // no room for some name: a smaller drawing leaves more
        }
    }
    return best;
}

void draw_near(std::vector<Name>& names, double width, double height) {
    // Beside what is drawn, from the middle of a line of braille; a row is a line of braille and the gap around it. What stands
    // free of the rows before it does so here, too. Settings.
    constexpr double kFirst = 7, kRow = 11, kSameRow = 4, kAside = 8, kFree = 20;
    // The name of an upright axis stands above it, where its words do not push the drawing aside.
    for (Name& name : names) {
        if (name.within <= 0 || (name.at.x >= 0 && name.at.x <= width) || name.at.y > height) continue;
        name.at = {std::clamp(name.at.x, 0.0, width), std::min(name.at.y, -kFirst)};
    }
    for (const bool below : {false, true}) {
        std::vector<std::pair<double, Name*>> out;
        for (Name& name : names) {
            const double down = below ? name.at.y - height : -name.at.y, across = std::max(-name.at.x, name.at.x - width);
            if (down > 0 && down >= across) out.push_back({down, &name});
        }
        std::stable_sort(out.begin(), out.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
        double row = 0, before = 0;
        for (const auto& [down, name] : out) {
            if (row == 0)
                row = std::min(down, kFirst);
            else if (down - before > kSameRow)
                row = std::min(down, row + (down - before > kFree ? 2 : 1) * kRow);
            before = down;
            name->at.y = below ? height + row : -row;
        }
    }
    for (Name& name : names) {
        const double down = std::max(-name.at.y, name.at.y - height);
        if (-name.at.x > std::max(down, kAside)) name.at.x = -kAside;
        if (name.at.x - width > std::max(down, kAside)) name.at.x = width + kAside;
    }
}

}  // namespace tactics
