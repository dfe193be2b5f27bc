// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/views.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "tactics/error.h"
#include "tactics/geometry/apart_lines.h"
#include "tactics/geometry/box.h"
#include "tactics/geometry/distance.h"
#include "tactics/geometry/region_place.h"
#include "tactics/solid/named_part.h"
#include "tactics/solid/object_regions.h"
#include "tactics/solid/outline.h"
#include "tactics/solid/seen_edges.h"

namespace tactics {

namespace {

constexpr double kBetween = 12;  // mm between two views, so that a finger does not take them for one thing
// mm above a view: a line of braille, 6.6 mm high, with 3.2 mm and half a line above and below it, and some more, so that the
// title stands there without a lead line.
constexpr double kTitle = 16;
constexpr double kLater =
    6.4;  // mm within which other names may stand, which is what they may anyhow: titles are set before them

// One of the four.
struct View {
    SourceWords title;
    SourceWords described;  // of what is in it: {0} is the title
    const ViewPlane* plane;
    bool cuts = false;                 // shows what its plane cuts
    std::vector<DrawnSide> sides;      // mm of the model; thick before others
    std::vector<std::uint32_t> parts;  // of each side
    Box box = kNothing;                // of all parts, in that plane
    Point at;                          // its left upper corner in the drawing
};

Box box_in(const std::vector<ModelPart>& parts, const ViewPlane& plane) {
    Box box = kNothing;
    for (const ModelPart& part : parts)
        for (const Patch& patch : part.solid.patches)
            for (const auto& ring : patch.rings)
                for (const Point3& place : ring) box.take(flat_place(place, plane));
    return box;
}

// Towards the reader, of a share of the depth from the front.
double depth_at(const std::vector<ModelPart>& parts, const ViewPlane& plane, double share) {
    double far = kNowhere, near = -kNowhere;
    for (const ModelPart& part : parts)
        for (const Patch& patch : part.solid.patches)
            for (const auto& ring : patch.rings)
                for (const Point3& place : ring) {
                    far = std::min(far, dot(place, plane.toward));
                    near = std::max(near, dot(place, plane.toward));
                }
    return near + share * (far - near);
}

void cut(View& view, const std::vector<ModelPart>& parts, double at) {
    view.sides.clear();
    view.parts.clear();
    for (std::uint32_t i = 0; i < parts.size(); ++i)
        for (const DrawnSide& side : cut_sides(parts[i], *view.plane, at)) {
            view.sides.push_back(side);
            view.parts.push_back(i);
        }
}

// Where it cuts most parts; of several such places the one nearest to the middle.
void cut_best(View& view, const std::vector<ModelPart>& parts) {
    constexpr double kShares[] = {0.5, 0.45, 0.55, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8};
    std::size_t most = 0;
    View best = view;
    for (const double share : kShares) {
        cut(view, parts, depth_at(parts, *view.plane, share));
        std::vector<std::uint32_t> cut_parts = view.parts;
        cut_parts.erase(std::unique(cut_parts.begin(), cut_parts.end()), cut_parts.end());
        if (cut_parts.size() <= most) continue;
        most = cut_parts.size();
        best = view;
    }
    view = std::move(best);
}

double length_of(const std::vector<Stroke>& strokes) {
    double sum = 0;
    for (const Stroke& stroke : strokes) sum += length_of(stroke);
    return sum;
}

// Lines of a view in the drawing: those that a finger can tell apart. `dropped` grows by the mm of the others.
std::vector<Stroke> lines_of(const View& view, double scale, double touching, const Medium& medium, double& dropped) {
    std::vector<DrawnSide> sides = view.sides;
    std::erase_if(sides, [&](const DrawnSide& side) { return !(distance(side.from, side.to) > touching); });
    std::vector<Stroke> strokes = joined(merged(sides, touching), touching);
    for (Stroke& stroke : strokes)
        for (Point& at : stroke.points)
            at = {view.at.x + (at.x - view.box.left) * scale, view.at.y + (at.y - view.box.top) * scale};
    const double whole = length_of(strokes);
    strokes = apart_lines(std::move(strokes), least_apart(medium, medium.line, medium.line), medium.shortest);
    for (Stroke& stroke : strokes) stroke.line = LineClass::normal;
    dropped += whole - length_of(strokes);
    return strokes;
}

// The place of a part in a view: its outline; in the section, its cut.
std::vector<std::vector<Point>> rings_of(const View& view, const ModelPart& part, std::uint32_t number, double touching) {
    std::vector<std::vector<Point>> rings;
    if (view.cuts) {
        std::vector<DrawnSide> own;
        for (std::size_t i = 0; i < view.sides.size(); ++i)
            if (view.parts[i] == number) own.push_back(view.sides[i]);
        for (Stroke& stroke : joined(own, touching))
            if (stroke.closed) rings.push_back(std::move(stroke.points));
        return rings;
    }
    const OutlineOfPart outline = outline_of(part.solid, view.plane->toward, view.plane->right, -1 * view.plane->down);
    for (const auto& ring : outline.rings) {
        rings.emplace_back();
        for (const Point3& place : ring) rings.back().push_back(flat_place(place, *view.plane));
    }
    return rings;
}

class Laying {
public:
    Laying(const Model& model, const std::vector<ModelPart>& parts, std::array<View, 4>& views, const Medium& medium,
           const std::string& language)
        : parts_(parts), views_(views), medium_(medium), language_(language), touching_(touching_in(parts)) {
        for (const ModelPart& part : parts) {
            if (made_.objects.empty() || made_.objects.back().object != part.object) {
                FoldedObject& fresh = made_.objects.emplace_back();
                fresh.object = part.object;
                fresh.path = path_of(model, part.object);
                fresh.name = spoken_name(model, part.object);
                fresh.fate = FoldedObject::Fate::hidden;
            }
            FoldedObject& one = made_.objects.back();
            one.form = part.form;
            one.size = std::max(one.size, extent_of(part));
        }
    }

    FoldOut run(double width, double height) {
        place_views(width, height);
        find_small();
        for (View& view : views_) leave_small_out(view);
        for (View& view : views_) lay(view);
        for (const FoldedObject& one : made_.objects)
            if (one.fate != FoldedObject::Fate::drawn) {
                Region& region = regions_.emplace_back();
                region.name = called(one);
                region.path = one.path;
                region.description = one.fate == FoldedObject::Fate::small ? phrase("too small to be felt at this size")
                                                                           : phrase("behind other things or too close to them");
            } else if (!one.name.empty()) {
                made_.drawing.names.push_back({one.at, one.name, "the model", kLater, true});
            }
        made_.drawing.regions = std::move(regions_);
        const Phrase top = phrase(views_[0].title), section = phrase(views_[3].title);
        made_.drawing.remarks = {
            views_[3].sides.empty()
                ? phrase("It is seen from above, called {0}; below that from the front; beside that from the right-hand side.",
                         top)
                : phrase(
                      "It is seen from above, called {0}; below that from the front; beside that from the right-hand side; and "
                      "above that, called {1}, cut through by a plane parallel to the front.",
                      top, section)};
        return std::move(made_);
    }

    double dropped() const { return dropped_; }  ///< mm of lines that could not be told apart from others

private:
    // As large as there is room, all in the same scale: top over front, section over side.
    void place_views(double width, double height) {
        const double edge = medium_.thick_line / 2;
        View &top = views_[0], &front = views_[1], &side = views_[2], &section = views_[3];
        for (View* view : {&top, &front, &side}) view->box = box_in(parts_, *view->plane);
        section.box = front.box;
        const double left = std::max(top.box.width(), front.box.width()), right = std::max(side.box.width(), section.box.width());
        const double upper = std::max(top.box.height(), section.box.height()),
                     lower = std::max(front.box.height(), side.box.height());
        made_.scale = std::min((width - 2 * edge - kBetween) / std::max(left + right, 1e-9),
                               (height - 2 * edge - 2 * kTitle) / std::max(upper + lower, 1e-9));
        if (!(made_.scale > 0))
            throw Error(Fault::usage, "the model", phrase("there is no room for four views; take larger paper"));
        Drawing& drawing = made_.drawing;
        drawing.width = (left + right) * made_.scale + kBetween + 2 * edge;
        drawing.height = (upper + lower) * made_.scale + 2 * kTitle + 2 * edge;
        const double first = edge + kTitle, second = first + upper * made_.scale + kTitle;
        const double beside = edge + left * made_.scale + kBetween;
        // The view from above stands on the front view, the section at the height of its row's lower end.
        const auto sink = [&](const View& view) { return (upper - view.box.height()) * made_.scale; };
        top.at = {edge, first + sink(top)};
        front.at = {edge, second};
        side.at = {beside, second};
        section.at = {beside, first + sink(section)};
    }

    void find_small() {
        for (const ModelPart& part : parts_) small_.push_back(extent_of(part) * made_.scale < medium_.shortest);
        for (FoldedObject& one : made_.objects) one.fate = FoldedObject::Fate::small;
        std::size_t object = 0;
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            while (made_.objects[object].object != parts_[i].object) ++object;
            if (small_[i] == 0) made_.objects[object].fate = FoldedObject::Fate::hidden;
        }
    }

    void leave_small_out(View& view) const {
        std::vector<DrawnSide> sides;
        std::vector<std::uint32_t> parts;
        for (std::size_t i = 0; i < view.sides.size(); ++i) {
            if (small_[view.parts[i]] != 0) continue;
            sides.push_back(view.sides[i]);
            parts.push_back(view.parts[i]);
        }
        view.sides = std::move(sides);
        view.parts = std::move(parts);
    }

    void lay(View& view) {
        const std::vector<Stroke> strokes = lines_of(view, made_.scale, touching_, medium_, dropped_);
        if (strokes.empty()) return;
        Drawing& drawing = made_.drawing;
        drawing.names.push_back({{view.at.x + view.box.width() * made_.scale / 2, view.at.y - kTitle / 2},
                                 phrase(view.title).in(language_),
                                 "the views",
                                 0,
                                 true});
        const std::vector<char> felt = felt_parts(view, strokes);
        std::vector<Region> regions;
        std::vector<double> toward;
        std::vector<std::size_t> of;  // the object of each region
        std::size_t object = 0;
        for (std::uint32_t i = 0; i < parts_.size(); ++i) {
            while (made_.objects[object].object != parts_[i].object) ++object;
            FoldedObject& one = made_.objects[object];
            if (felt[i] == 0) continue;
            if (of.empty() || of.back() != object) {
                regions.push_back({called(one), one.path, described(view), {{"kept", 1}}, {}, {}});
                toward.push_back(-kNowhere);
                of.push_back(object);
            }
            add_rings(regions.back(), view, i);
            toward.back() = std::max(toward.back(), nearest(parts_[i], *view.plane));
            if (!regions.back().rings.empty()) ++one.kept;
        }
        for (std::size_t i = 0; i < regions.size(); ++i) {
            if (regions[i].rings.empty()) continue;
            FoldedObject& one = made_.objects[of[i]];
            regions[i].at = place_in(regions[i]);
            if (one.fate != FoldedObject::Fate::drawn) one.at = regions[i].at;
            one.fate = FoldedObject::Fate::drawn;
        }
        for (std::size_t i = regions.size(); i-- > 0;)
            if (regions[i].rings.empty()) {
                regions.erase(regions.begin() + static_cast<std::ptrdiff_t>(i));
                toward.erase(toward.begin() + static_cast<std::ptrdiff_t>(i));
            }
        for (Region& region : in_reading_order(std::move(regions), toward)) regions_.push_back(std::move(region));
        drawing.strokes.insert(drawing.strokes.end(), strokes.begin(), strokes.end());
    }

    static Phrase described(const View& view) { return phrase(view.described, phrase(view.title)); }

    static double nearest(const ModelPart& part, const ViewPlane& plane) {
        double toward = -kNowhere;
        for (const Patch& patch : part.solid.patches)
            for (const Point3& place : patch.rings.front()) toward = std::max(toward, dot(place, plane.toward));
        return toward;
    }

    void add_rings(Region& region, const View& view, std::uint32_t part) const {
        for (std::vector<Point> ring : rings_of(view, parts_[part], part, touching_)) {
            for (Point& at : ring)
                at = {view.at.x + (at.x - view.box.left) * made_.scale, view.at.y + (at.y - view.box.top) * made_.scale};
            region.rings.push_back(std::move(ring));
        }
    }

    // Some of what is seen of it has stayed.
    std::vector<char> felt_parts(const View& view, const std::vector<Stroke>& strokes) const {
        constexpr double kOnLine = 0.5;  // mm
        std::vector<char> felt(parts_.size(), 0);
        for (std::size_t i = 0; i < view.sides.size(); ++i) {
            if (felt[view.parts[i]] != 0) continue;
            const DrawnSide& side = view.sides[i];
            const Point at{view.at.x + ((side.from.x + side.to.x) / 2 - view.box.left) * made_.scale,
                           view.at.y + ((side.from.y + side.to.y) / 2 - view.box.top) * made_.scale};
            felt[view.parts[i]] = std::any_of(strokes.begin(), strokes.end(), [&](const Stroke& stroke) {
                const std::size_t n = stroke.points.size(), sides = stroke.closed ? n : n - 1;
                for (std::size_t k = 0; k < sides; ++k)
                    if (distance_to_segment(at, stroke.points[k], stroke.points[(k + 1) % n]) < kOnLine) return true;
                return false;
            });
        }
        return felt;
    }

    const std::vector<ModelPart>& parts_;
    std::array<View, 4>& views_;
    const Medium& medium_;
    std::string language_;
    double touching_;
    FoldOut made_;
    std::vector<Region> regions_;
    std::vector<char> small_;  // of each part
    double dropped_ = 0;       // mm
};

}  // namespace

FoldOut views_of(const Model& whole, double width, double height, const Medium& medium, const FoldWish& wish,
                 std::vector<Phrase>& notes) {
    const Model alone = wish.part.empty() ? Model{} : part_named(whole, wish.part);
    const Model& model = wish.part.empty() ? whole : alone;
    const std::vector<ModelPart> parts = parts_of(model, wish.parts, wish.objects, notes);
    if (parts.empty()) throw Error(Fault::failed, "the model", phrase("it has no faces with an area, and nothing to draw"));
    std::array<View, 4> views{
        View{SourceWords("top"), SourceWords("seen from above, in the view called {0}"), &kFromAbove, false, {}, {}, {}, {}},
        View{SourceWords("front"),
             SourceWords("seen from the front, in the view called {0}"),
             &kFromTheFront,
             false,
             {},
             {},
             {},
             {}},
        View{
            SourceWords("side"), SourceWords("seen from the side, in the view called {0}"), &kFromTheSide, false, {}, {}, {}, {}},
        View{SourceWords("section"), SourceWords("cut through, in the view called {0}"), &kFromTheFront, true, {}, {}, {}, {}}};
    bool complete = true;
    for (std::size_t i = 0; i < 3; ++i) {
        SeenEdges seen = seen_edges(parts, *views[i].plane, touching_in(parts));
        views[i].sides = std::move(seen.edges);
        views[i].parts = std::move(seen.part);
        complete = complete && seen.complete;
    }
    if (!complete) notes.push_back(phrase("there is so much in it that its smaller parts are left out of the views"));
    if (wish.section > 0)
        cut(views[3], parts, depth_at(parts, *views[3].plane, wish.section));
    else
        cut_best(views[3], parts);
    Laying laying(model, parts, views, medium, wish.language);
    FoldOut made = laying.run(width, height);
    made.up = model.up;
    if (laying.dropped() > medium.shortest)
        notes.push_back(
            phrase("{0} mm of lines are so close to others that they are left out of the views; draw a part alone to feel them",
                   numeral(std::round(laying.dropped()))));
    return made;
}

}  // namespace tactics
