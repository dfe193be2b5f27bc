// SPDX-License-Identifier: Apache-2.0
// Compares folded-out models with plain unfolding of a solid: breadth first from its largest face, regardless of overlaps.
//
//   fold_out MODEL...            a line a model, and means
//   fold_out --effort MODEL...   CSV: rating against milliseconds as the search tries more layouts
//
// objects: that have faces; faces: plane ones, whatever polygons they were cut into.
// one piece: the share of objects that are drawn as one piece, of those that are drawn (by the union of their faces).
// overlaps: pairs of faces that lie on each other by more than a thousandth of the smaller one, counted by GEOS (Debian:
// libgeos-dev;
//   LGPL, no part of the program). What stands on a face that lies where it is may lie within it: that is no overlap. Of the
//   plain way only pairs of one net count, of ours all in the drawing.
// shown: the share of faces that a hand can reach which are laid out and overlap no other. Ours counts an outline of what is
// round or
//   bent as a face, the plain way each of its facets.
// ms: of the processor, the median of five runs, from the model as it was read to the drawing, or to the nets.
// Overlaps and shown are of the layout as such, from above and without a gap between things: nothing is too small there, and
// nothing is moved.
#include "tactics/solid/fold_out.h"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/error.h"
#include "tactics/readers/model.h"
#include "tactics/solid/lay_flat.h"
#include "tactics/solid/panels.h"
#include "tactics/solid/thing.h"
#include "tests/geos_shape.h"

namespace {

using namespace tactics;
using tests::Geos;
using tests::GeosShape;

constexpr double kWidth = 180, kHeight = 267;  // mm: the room of A4
constexpr int kRuns = 5;

struct Face {
    std::uint32_t object = 0;
    int net = 0;
    bool reached = true, lies = false;  // lies: where it is, so that others may stand on it
    double height = 0;
    FlatShape shape;
};

struct Scores {
    double objects = 0, whole = 0, overlaps = 0, reached = 0, shown = 0, ms = 0;
};

double milliseconds(const auto& run) {
    std::vector<double> times;
    for (int i = 0; i < kRuns; ++i) {
        const std::clock_t begin = std::clock();
        run();
        times.push_back(1000.0 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    }
    std::nth_element(times.begin(), times.begin() + kRuns / 2, times.end());
    return times[kRuns / 2];
}

// A face laid into the plane: where a point of it comes to be.
struct Laying {
    Point3 origin, along, across;
    Point at, to;  // of the origin, and which way `along` goes
    Point of(const Point3& point) const {
        const double u = dot(point - origin, along), v = dot(point - origin, across);
        return {at.x + u * to.x - v * to.y, at.y + u * to.y + v * to.x};
    }
};

FlatShape laid(const Patch& patch, const Laying& sheet) {
    std::vector<std::vector<Point>> rings;
    for (const auto& ring : patch.rings) {
        rings.emplace_back();
        for (const Point3& point : ring) rings.back().push_back(sheet.of(point));
    }
    return flat_shape(std::move(rings));
}

void unfold(std::vector<Face>& faces, const ModelPart& part, int& nets) {
    const std::vector<Patch>& patches = part.solid.patches;
    std::vector<std::vector<const Seam*>> seams(patches.size());
    for (const Seam& seam : part.solid.seams) {
        seams[seam.one].push_back(&seam);
        seams[seam.other].push_back(&seam);
    }
    std::vector<char> done(patches.size(), 0);
    std::vector<Laying> sheets(patches.size());
    for (std::uint32_t root = 0; root < patches.size(); ++root) {  // the largest first
        if (done[root] != 0) continue;
        const Point3& from = patches[root].rings.front()[0];
        const Point3 along = unit(patches[root].rings.front()[1] - from);
        sheets[root] = {from, along, cross(patches[root].normal, along), {}, {1, 0}};
        done[root] = 1;
        const int net = nets++;
        for (std::deque<std::uint32_t> waiting = {root}; !waiting.empty(); waiting.pop_front()) {
            const std::uint32_t one = waiting.front();
            faces.push_back({part.object, net, true, false, 0, laid(patches[one], sheets[one])});
            for (const Seam* seam : seams[one]) {
                const std::uint32_t other = seam->one == one ? seam->other : seam->one;
                const Point begin = sheets[one].of(seam->from), end = sheets[one].of(seam->to);
                const double length = distance(begin, end);
                if (done[other] != 0 || !(length > 0)) continue;
                const Point3 side = unit(seam->to - seam->from);
                sheets[other] = {seam->from,
                                 side,
                                 cross(patches[other].normal, side),
                                 begin,
                                 {(end.x - begin.x) / length, (end.y - begin.y) / length}};
                done[other] = 1;
                waiting.push_back(other);
            }
        }
    }
}

void find_overlaps(Scores& scores, const std::vector<Face>& faces, double touching, const Geos& geos) {
    std::vector<GeosShape> shapes;
    for (const Face& face : faces) shapes.push_back(GeosShape::area(geos, face.shape.rings));
    std::vector<char> covered(faces.size(), 0);
    for (std::size_t i = 0; i < faces.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const Face &a = faces[i], &b = faces[j];
            if (a.net != b.net || (a.lies && b.lies) || !boxes_meet(a.shape, b.shape, 0)) continue;
            const double smaller = std::min(shapes[i].area(), shapes[j].area());
            const double least = std::max(1e-3 * smaller, touching * std::min(shapes[i].length(), shapes[j].length()));
            const double shared = shapes[i].shared_with(shapes[j]);
            if (shared <= least) continue;
            const std::size_t standing = a.lies ? j : i;
            const Face& ground = a.lies ? a : b;
            if (ground.lies && ground.height <= faces[standing].height + touching && shared > shapes[standing].area() - least)
                continue;
            ++scores.overlaps;
            covered[i] = covered[j] = 1;
        }
    for (std::size_t i = 0; i < faces.size(); ++i) scores.shown += faces[i].reached && covered[i] == 0;
}

Scores plain(const Model& model, std::size_t& count, const Geos& geos) {
    Scores scores;
    std::vector<Phrase> notes;
    const PartWish whole{.simplify = false};
    std::vector<ModelPart> parts;
    std::vector<Face> faces;
    int nets = 0;
    scores.ms = milliseconds([&] {
        parts = parts_of(model, whole, {}, notes);
        faces.clear();
        nets = 0;
        for (const ModelPart& part : parts) unfold(faces, part, nets);
    });
    count = faces.size();
    Panels panels;
    for (std::uint32_t i = 0; i < parts.size(); ++i)
        for (const Patch& patch : parts[i].solid.patches)
            panels.panels.push_back({i, PanelKind::side, patch.normal, patch.rings, patch.area});
    find_reached(panels, parts, {});
    scores.reached = static_cast<double>(
        std::count_if(panels.panels.begin(), panels.panels.end(), [](const Panel& panel) { return panel.reached; }));
    std::vector<int> pieces(model.objects.size(), 0);
    for (std::size_t i = 0; i < faces.size(); ++i) pieces[faces[i].object] += i == 0 || faces[i].net != faces[i - 1].net;
    for (const int number : pieces) {
        scores.objects += number > 0;
        scores.whole += number == 1;
    }
    find_overlaps(scores, faces, touching_in(parts), geos);
    return scores;
}

// All that a layout from above is made of.
struct Flattening {
    explicit Flattening(const Model& model) {
        std::vector<Phrase> notes;
        parts = parts_of(model, {}, {}, notes);
        thing = things_of(model, parts);
        panels = panels_of(parts, thing, kFromAbove);
        find_reached(panels, parts, {});
    }
    FlatLayout laid(int effort) const { return lay_flat(parts, panels, thing, kFromAbove, {{}, gap, effort}); }

    std::vector<ModelPart> parts;
    std::vector<std::uint32_t> thing;
    Panels panels;
    double gap = 0;  // mm of the model
};

Scores ours(const Model& model, const Geos& geos) {
    Scores scores;
    std::vector<Phrase> notes;
    const Medium& medium = find_medium("swell", "");
    scores.ms = milliseconds([&] { fold_out(model, kWidth, kHeight, medium, {}, notes); });
    const Flattening flat(model);
    const auto& [parts, thing, panels, gap] = flat;
    const FlatLayout layout = flat.laid(LayoutWish{}.effort);
    std::vector<std::size_t> outlines(parts.size(), 0);
    for (const Panel& panel : panels.panels)
        scores.reached +=
            panel.reached && (!is_view(panel.kind) || ++outlines[panel.part] <= most_outlines(parts[panel.part].form));
    std::vector<Face> faces;
    std::vector<std::vector<std::size_t>> of_object(model.objects.size());
    std::vector<GeosShape> shapes;
    for (const PlacedPanel& placed : layout.panels) {
        const Panel& panel = panels.panels[placed.panel];
        faces.push_back(
            {parts[panel.part].object, 0, panel.reached, placed.handling == Handling::kept, placed.height, placed.shape});
        of_object[faces.back().object].push_back(shapes.size());
        shapes.push_back(GeosShape::area(geos, placed.shape.rings));
    }
    for (const PlacedBar& bar : layout.bars) {
        of_object[parts[panels.bars[bar.bar].part].object].push_back(shapes.size());
        shapes.push_back(GeosShape::line(geos, {bar.from, bar.to}));
    }
    const double touching = touching_in(parts);
    for (const auto& places : of_object) {
        std::vector<const GeosShape*> pieces;
        for (const std::size_t place : places) pieces.push_back(&shapes[place]);
        scores.objects += !pieces.empty();
        scores.whole += !pieces.empty() && GeosShape::pieces_of(geos, pieces, 20 * touching) == 1;
    }
    find_overlaps(scores, faces, touching, geos);
    return scores;
}

double percent(double part, double all) { return all > 0 ? 100 * part / all : 100; }

void print(const std::string& name, double objects, double faces, const Scores& us, const Scores& them) {
    const auto shown = [](const Scores& s) { return std::min(100.0, percent(s.shown, s.reached)); };
    std::printf("| %s | %.0f | %.0f | %.0f | %.0f | %.0f | %.0f | %.0f | %.0f | %.1f | %.1f |\n", name.c_str(), objects, faces,
                percent(us.whole, us.objects), percent(them.whole, them.objects), us.overlaps, them.overlaps, shown(us),
                shown(them), us.ms, them.ms);
}

void add(Scores& sum, const Scores& one) {
    sum.objects += one.objects;
    sum.whole += one.whole;
    sum.overlaps += one.overlaps;
    sum.reached += one.reached;
    sum.shown += one.shown;
    sum.ms += one.ms;
}

// One that cannot be read is told, and left out.
bool read(const std::string& path, Model& model) {
    try {
        std::vector<Phrase> notes;
        Source source = open_source(path);
        model = read_model(source, notes);
        return true;
    } catch (const Error& error) {
        std::fprintf(stderr, "fold_out: %s\n", error.what());
        return false;
    }
}

void table(const std::vector<std::pair<std::string, Model>>& models) {
    std::printf(
        "| model | objects | faces | in one piece, %% | plain | overlaps | plain | faces shown, %% | plain | ms | plain |\n"
        "|---|---|---|---|---|---|---|---|---|---|---|\n");
    const Geos geos;
    Scores us, them;
    double all_objects = 0, all_faces = 0;
    for (const auto& [name, model] : models) {
        std::size_t faces = 0;
        const Scores other = plain(model, faces, geos), own = ours(model, geos);
        print(name, other.objects, static_cast<double>(faces), own, other);
        std::fflush(stdout);
        add(us, own);
        add(them, other);
        all_objects += other.objects;
        all_faces += static_cast<double>(faces);
    }
    print("all", all_objects, all_faces, us, them);
}

// The mean of all models, in the plane from above and with the gap that swell paper asks for at the size of the drawing: what is
// shown less what is asked of the reader, and the time of the search alone.
void efforts(const std::vector<std::pair<std::string, Model>>& models) {
    std::printf("effort,ms,rating\n");
    const Medium& medium = find_medium("swell", "");
    std::vector<Flattening> all;
    for (const auto& [name, model] : models) {
        std::vector<Phrase> notes;
        Flattening& one = all.emplace_back(model);
        one.gap = least_apart(medium, medium.line, medium.line) / fold_out(model, kWidth, kHeight, medium, {}, notes).scale;
    }
    for (const int effort : {0, 1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024}) {
        double ms = 0, rating = 0;
        for (const Flattening& one : all) {
            FlatLayout layout;
            ms += milliseconds([&] { layout = one.laid(effort); });
            rating += layout.rating.value();
        }
        const double count = static_cast<double>(models.size());
        std::printf("%d,%.3f,%.5f\n", effort, ms / count, rating / count);
        std::fflush(stdout);
    }
}

}  // namespace

int main(int count, char** words) {
    std::vector<std::string> paths(words + 1, words + count);
    const bool by_effort = !paths.empty() && paths.front() == "--effort";
    if (by_effort) paths.erase(paths.begin());
    std::vector<std::pair<std::string, Model>> models;
    for (const std::string& path : paths)
        if (Model model; read(path, model)) models.emplace_back(path.substr(path.find_last_of('/') + 1), std::move(model));
    if (models.empty()) {
        std::fprintf(stderr, "fold_out: name models that can be read: fold_out [--effort] MODEL...\n");
        return 1;
    }
    by_effort ? efforts(models) : table(models);
    return 0;
}
