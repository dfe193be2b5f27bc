// SPDX-License-Identifier: Apache-2.0
// Whether a model gives the same drawing however its file was written: corners off by a millionth of its extent, faces and their
// corners in another order, lengths in another unit, faces cut into triangles with corners of some on the sides of others.
//
//   fold_stability MODEL...   two lines a model, and how many of them stay the same; ends with 1 if any does not
//
// The drawing is the same: what was done with each object, and each place of a line within 0.5 mm of a line of the other.
// The page is the same: its lines likewise, on a sheet of the same shape, and each name beside the same place, in the same words
// or letters. It is laid out and mended as for `convert`, on swell paper that may be turned.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "tactics/error.h"
#include "tactics/geometry/course.h"
#include "tactics/geometry/triangulate.h"
#include "tactics/job/mending.h"
#include "tactics/job/model_drawing.h"
#include "tactics/job/wishes.h"
#include "tactics/layout/lay_out.h"
#include "tactics/readers/model.h"
#include "tactics/solid/fold_out.h"

namespace {

using namespace tactics;

constexpr double kWidth = 180, kHeight = 267;  // mm: the room of A4
constexpr double kSame = 0.5;                  // mm: half of what a finger tells

class Chance {
public:
    double next() { return static_cast<double>(engine_()) / 4294967295.0; }  // 0 to 1
    std::size_t below(std::size_t count) {
        return std::min(count - 1, static_cast<std::size_t>(next() * static_cast<double>(count)));
    }

private:
    std::mt19937 engine_{7};
};

double extent_of(const Model& model) {
    Point3 low = model.vertices.front(), high = low;
    for (const Point3& at : model.vertices) {
        low = {std::min(low.x, at.x), std::min(low.y, at.y), std::min(low.z, at.z)};
        high = {std::max(high.x, at.x), std::max(high.y, at.y), std::max(high.z, at.z)};
    }
    return length_of(high - low);
}

Model trembling(Model model) {
    Chance chance;
    const double by = 1e-6 * extent_of(model);
    for (Point3& at : model.vertices) at = at + by * Point3{chance.next() - 0.5, chance.next() - 0.5, chance.next() - 0.5};
    return model;
}

Model reordered(Model model) {
    Chance chance;
    for (const ModelObject& object : model.objects)
        for (std::uint32_t i = object.count; i > 1; --i)
            std::swap(model.faces[object.first + i - 1], model.faces[object.first + chance.below(i)]);
    for (const ModelFace& face : model.faces) {
        const auto begin = model.corners.begin() + face.first;
        std::rotate(begin, begin + static_cast<std::ptrdiff_t>(chance.below(face.count)), begin + face.count);
    }
    return model;
}

Model in_another_unit(Model model) {
    for (Point3& at : model.vertices) at = 10 * at;
    for (ModelObject& object : model.objects)
        for (Point3* at : {&object.frame.middle, &object.frame.a, &object.frame.b, &object.frame.c}) *at = 10 * *at;
    return model;
}

using Triangle = std::array<Point3, 3>;

// Sides of some triangles have a corner that their neighbours do not have.
std::vector<Triangle> cut(const Model& model, const ModelFace& face, Chance& chance) {
    std::vector<Point3> ring;
    for (std::uint32_t i = 0; i < face.count; ++i) ring.push_back(model.vertices[model.corners[face.first + i]]);
    std::vector<Triangle> made;
    for (const auto& [a, b, c] : triangulate(ring)) {
        Triangle one = {ring[a], ring[b], ring[c]};
        std::rotate(one.begin(), one.begin() + static_cast<std::ptrdiff_t>(chance.below(3)), one.end());
        if (chance.next() < 0.5) {
            made.push_back(one);
            continue;
        }
        const Point3 at = one[0] + (0.2 + 0.6 * chance.next()) * (one[1] - one[0]);
        made.push_back({one[0], at, one[2]});
        made.push_back({at, one[1], one[2]});
    }
    return made;
}

Model split(const Model& model) {
    Chance chance;
    Model made;
    made.title = model.title;
    made.viewed_from = model.viewed_from;
    for (ModelObject object : model.objects) {
        const auto first = static_cast<std::uint32_t>(made.faces.size());
        for (std::uint32_t i = object.first; i < object.first + object.count; ++i)
            for (const Triangle& one : cut(model, model.faces[i], chance)) {
                made.faces.push_back({static_cast<std::uint32_t>(made.corners.size()), 3});
                for (const Point3& at : one) {
                    made.corners.push_back(static_cast<std::uint32_t>(made.vertices.size()));
                    made.vertices.push_back(at);
                }
            }
        object.first = first;
        object.count = static_cast<std::uint32_t>(made.faces.size()) - first;
        made.objects.push_back(std::move(object));
    }
    return made;
}

FoldOut drawn(const Model& model, double unit) {
    std::vector<Phrase> notes;
    FoldWish wish;
    wish.reach.hand *= unit;
    return fold_out(model, kWidth, kHeight, find_medium("swell", ""), wish, notes);
}

Page page_of(const Model& model, double unit) {
    const Wishes wishes;
    const Output output = output_to("page.svg");
    const Sheet sheet = sheet_for(wishes, *output.format, {"model", {output}});
    ModelDrawingWish wish;
    wish.fold.reach.hand *= unit;
    ModelDrawing drawing(std::make_shared<const Model>(model), wish);
    const Drawing& made = drawing.on(sheet).drawing;
    const Arrangement first = arrange(sheet, made.width / made.height);
    const double width = first.place.drawing.width;
    const Mended mended = mend_for(*sheet.medium, width, scaled_to(made, width), false);
    return lay_out(mended.drawing, sheet, arrange(sheet, mended.drawing.width / mended.drawing.height));
}

// The share of a drawing's lines that lie on no line of the other.
template <typename Lines>
double elsewhere(const Lines& one, const Lines& other) {
    constexpr double kStep = 1;
    std::size_t all = 0, off = 0;
    const auto is_on = [&](Point at) {
        for (const auto& stroke : other.strokes)
            for (std::size_t i = 0; i + (stroke.closed ? 0 : 1) < stroke.points.size(); ++i)
                if (distance_to_segment(at, stroke.points[i], stroke.points[(i + 1) % stroke.points.size()]) <= kSame)
                    return true;
        return false;
    };
    for (const auto& stroke : one.strokes)
        for (std::size_t i = 0; i + (stroke.closed ? 0 : 1) < stroke.points.size(); ++i) {
            const Point a = stroke.points[i], b = stroke.points[(i + 1) % stroke.points.size()];
            const int steps = 1 + static_cast<int>(distance(a, b) / kStep);
            for (int step = 0; step <= steps; ++step) {
                const double share = static_cast<double>(step) / steps;
                ++all;
                off += !is_on({a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)});
            }
        }
    return all > 0 ? static_cast<double>(off) / static_cast<double>(all) : 0;
}

std::size_t otherwise(const FoldOut& one, const FoldOut& other) {
    if (one.objects.size() != other.objects.size()) return std::max(one.objects.size(), other.objects.size());
    std::size_t count = 0;
    for (std::size_t i = 0; i < one.objects.size(); ++i) {
        const auto told = [](const FoldedObject& it) {
            return std::tuple(it.path, it.form, it.fate, it.kept, it.folded, it.straightened, it.lying, it.flattened, it.wedges,
                              it.hanging, it.left_out);
        };
        count += told(one.objects[i]) != told(other.objects[i]);
    }
    return count;
}

// Names that are not there on the other page, or name another place or in another way.
std::size_t named_otherwise(const Page& one, const Page& other) {
    std::size_t count = std::max(one.names.size(), other.names.size());
    std::vector<char> taken(other.names.size(), 0);
    for (const PageName& name : one.names)
        for (std::size_t i = 0; i < other.names.size(); ++i) {
            const PageName& its = other.names[i];
            if (taken[i] != 0 || its.text != name.text || its.key != name.key || distance(its.thing, name.thing) > kSame ||
                distance(its.place.middle(), name.place.middle()) > kSame)
                continue;
            taken[i] = 1;
            --count;
            break;
        }
    return count;
}

bool is_told_same(const char* way, std::size_t others, const char* what, double lines) {
    const bool is_same = others == 0 && lines == 0;
    if (is_same)
        std::printf(" %s same;", way);
    else
        std::printf(" %s: %zu %s otherwise, %.1f %% of the lines elsewhere;", way, others, what, 100 * lines);
    return is_same;
}

template <typename Lines>
double either_elsewhere(const Lines& one, const Lines& other) {
    return std::max(elsewhere(one, other), elsewhere(other, one));
}

}  // namespace

int main(int count, char** words) {
    const std::pair<const char*, std::function<Model(const Model&)>> ways[] = {
        {"trembling", trembling}, {"reordered", reordered}, {"another unit", in_another_unit}, {"split", split}};
    constexpr double kUnits[] = {1, 1, 10, 1};
    std::size_t models = 0, same[std::size(ways)] = {}, same_pages[std::size(ways)] = {};
    for (int i = 1; i < count; ++i) {
        const std::string path = words[i];
        try {
            std::vector<Phrase> notes;
            Source source = open_source(path);
            const Model model = read_model(source, notes);
            const FoldOut first = drawn(model, 1);
            const Page page = page_of(model, 1);
            ++models;
            const std::string name = path.substr(path.find_last_of('/') + 1);
            std::printf("%s: drawing", name.c_str());
            for (std::size_t way = 0; way < std::size(ways); ++way) {
                const FoldOut other = drawn(ways[way].second(model), kUnits[way]);
                same[way] += is_told_same(ways[way].first, otherwise(first, other), "objects",
                                          either_elsewhere(first.drawing, other.drawing));
            }
            std::printf("\n%s: page", name.c_str());
            for (std::size_t way = 0; way < std::size(ways); ++way) {
                const Page other = page_of(ways[way].second(model), kUnits[way]);
                const bool turned = std::abs(page.width - other.width) > kSame;
                same_pages[way] += is_told_same(ways[way].first, named_otherwise(page, other), "names",
                                                turned ? 1 : either_elsewhere(page, other));
            }
            std::printf("\n");
            std::fflush(stdout);
        } catch (const Error& error) {
            std::fprintf(stderr, "fold_stability: %s\n", error.what());
        }
    }
    bool all = true;
    for (std::size_t way = 0; way < std::size(ways); ++way) {
        std::printf("%s: %zu drawings and %zu pages of %zu the same\n", ways[way].first, same[way], same_pages[way], models);
        all = all && same[way] == models && same_pages[way] == models;
    }
    return all ? 0 : 1;
}
