// SPDX-License-Identifier: Apache-2.0
// What merging and choosing go by, beside what people drew: rows of floats to be fitted to by filters/net/train/fit.py.
//     outline_features FOLDER learned|plain pairs|arcs|points|pages > rows
// FOLDER has images/ and gt/ as tactics evaluate takes them. A row of pairs: features of two regions when they were compared, the
// share of people for whom they are two things, how pure the regions are. A row of arcs: features, the same
// features as a disturbed copy of the picture has them, the share of its length that at least three people drew, the chance that
// who drew a main object has it on its outline, its length. A row of points: the number of a point in a thing that people agree
// on, features of a part of the picture that holds it, what the two overlap. A row of pages, as recipe photo draws them on A4:
// features, the share of its line that at least three people drew, the share of what they drew that is on it (-1: they drew
// nothing).
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "filters/arc_worth.h"
#include "filters/enlarged.h"
#include "filters/list.h"
#include "filters/net/nets.h"
#include "filters/outline_choice.h"
#include "filters/page_stakes.h"
#include "filters/page_trust.h"
#include "filters/region_tree_of.h"
#include "filters/silhouette_worth.h"
#include "tactics/error.h"
#include "tactics/layout/place.h"
#include "tactics/measure/consensus.h"
#include "tactics/measure/disturbance.h"
#include "tactics/measure/lines.h"
#include "tactics/measure/objects.h"
#include "tactics/measure/regions.h"
#include "tactics/measure/score.h"
#include "tactics/measure/truth.h"
#include "tactics/page.h"
#include "tactics/readers/read.h"
#include "tactics/recipe.h"

namespace {

using namespace tactics;
namespace fs = std::filesystem;

constexpr double kLeast = 220;  // square pixels of photographs of 481 x 321: a fingertip on A4

struct Truth {
    std::vector<PixelSet> drawn;
    std::vector<LabelMap> regions;
};

std::vector<std::string> files_in(const std::string& folder) {
    std::vector<std::string> files;
    for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path().string());
    return files;
}

void write(const std::vector<float>& row) { std::fwrite(row.data(), sizeof(float), row.size(), stdout); }

// For each node and person: the person's region that contains most of the node, and that share.
struct Most {
    std::uint32_t region = 0;
    double share = 0;
};
std::vector<std::vector<Most>> most_of(const RegionTree& tree, const Truth& truth) {
    const std::size_t people = truth.regions.size();
    std::vector<std::vector<std::map<std::uint32_t, double>>> counts(tree.nodes.size(),
                                                                     std::vector<std::map<std::uint32_t, double>>(people));
    for (std::size_t i = 0; i < tree.face.size(); ++i)
        for (std::size_t k = 0; k < people; ++k) counts[tree.face[i]][k][truth.regions[k].label[i]] += 1;
    std::vector<std::vector<Most>> most(tree.nodes.size(), std::vector<Most>(people));
    for (std::size_t n = 0; n < tree.nodes.size(); ++n)
        for (std::size_t k = 0; k < people; ++k) {
            if (tree.nodes[n].children[0] >= 0)
                for (const int child : tree.nodes[n].children)
                    for (const auto& [region, count] : counts[static_cast<std::size_t>(child)][k]) counts[n][k][region] += count;
            const auto best = std::max_element(counts[n][k].begin(), counts[n][k].end(),
                                               [](const auto& a, const auto& b) { return a.second < b.second; });
            most[n][k] = {best->first, best->second / tree.nodes[n].area};
        }
    return most;
}

void write_pairs(const Image& picture, const ContourMaps& maps, const RegionTree& tree, const PairWeights& weights,
                 const Truth& truth) {
    const auto most = most_of(tree, truth);
    const double people = static_cast<double>(truth.regions.size());
    region_tree_of(picture, maps, kLeast, weights, [&](std::uint32_t a, std::uint32_t b, const PairFeatures& features) {
        std::vector<float> row(features.begin(), features.end());
        double apart = 0, pure = 0;
        for (std::size_t k = 0; k < truth.regions.size(); ++k) {
            apart += most[a][k].region != most[b][k].region ? 1 : 0;
            pure += std::min(most[a][k].share, most[b][k].share);
        }
        row.push_back(static_cast<float>(apart / people));
        row.push_back(static_cast<float>(pure / people));
        write(row);
    });
}

// How many people drew within reach of each pixel.
std::vector<int> people_near(const Truth& truth, int width, int height) {
    const double reach = reach_of(width, height);
    const int steps = static_cast<int>(reach);
    std::vector<int> near(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
    for (const PixelSet& drawn : truth.drawn) {
        std::vector<bool> close(near.size(), false);
        for (const std::uint32_t pixel : drawn.pixels) {
            const int x = static_cast<int>(pixel) % width, y = static_cast<int>(pixel) / width;
            for (int v = std::max(y - steps, 0); v <= std::min(y + steps, height - 1); ++v)
                for (int u = std::max(x - steps, 0); u <= std::min(x + steps, width - 1); ++u)
                    if (std::hypot(u - x, v - y) <= reach)
                        close[static_cast<std::size_t>(v) * static_cast<std::size_t>(width) + static_cast<std::size_t>(u)] = true;
        }
        for (std::size_t i = 0; i < near.size(); ++i) near[i] += close[i] ? 1 : 0;
    }
    return near;
}

// Each picture has one copy; the kinds take turns.
Image copy_of(const Image& picture, std::size_t number) {
    constexpr std::string_view kKinds[] = {"JPEG 50", "noise 10", "half"};
    const auto all = disturbances();
    const auto kind = std::find_if(all.begin(), all.end(),
                                   [&](const Disturbance& d) { return d.name.text == kKinds[number % std::size(kKinds)]; });
    return enlarged(kind->apply(picture).image, picture.width, picture.height);
}

// For each pixel, the share of people with a main object whose outline is within reach of it.
std::vector<float> main_near(const Truth& truth, int width, int height) {
    Truth mains;
    for (const PixelSet& drawn : truth.drawn) {
        PixelSet outline = drawn;
        outline.pixels = main_outline(drawn);
        if (!outline.pixels.empty()) mains.drawn.push_back(std::move(outline));
    }
    const std::vector<int> near = people_near(mains, width, height);
    std::vector<float> share;
    for (const int people : near)
        share.push_back(mains.drawn.empty() ? 0.0f : static_cast<float>(people) / static_cast<float>(mains.drawn.size()));
    return share;
}

void write_arcs(const RegionTree& tree, const RegionTree& copy, const Truth& truth) {
    const std::vector<int> near = people_near(truth, tree.width, tree.height);
    const std::vector<float> main = main_near(truth, tree.width, tree.height);
    const auto features = arc_features_of(tree), in_copy = arc_features_of(copy);
    for (std::size_t i = 0; i < tree.arcs.size(); ++i) {
        if (tree.arcs[i].level <= 0 || copy.arcs[i].level <= 0) continue;
        double most = 0, any = 0, of_main = 0;
        for_each_side(tree.arcs[i], [&](int x, int y) {
            const int people =
                near[static_cast<std::size_t>(y) * static_cast<std::size_t>(tree.width) + static_cast<std::size_t>(x)];
            of_main += static_cast<double>(
                main[static_cast<std::size_t>(y) * static_cast<std::size_t>(tree.width) + static_cast<std::size_t>(x)]);
            most += people >= 3 ? 1 : 0;
            any += people >= 1 ? 1 : 0;
        });
        std::vector<float> row(features[i].begin(), features[i].end());
        row.insert(row.end(), in_copy[i].begin(), in_copy[i].end());
        const double length = steps_of(tree.arcs[i]);
        for (const double value : {most / length, of_main / length, length}) row.push_back(static_cast<float>(value));
        write(row);
    }
}

// A person points where the thing is deepest.
void write_points(const RegionTree& tree, const Truth& truth, int& number) {
    const std::vector<float> chances = arc_chances_of(tree).drawn;
    for (const AgreedObject& object : agreed_objects(truth.regions)) {
        std::vector<double> held(tree.nodes.size(), 0.0);  // pixels of it in each node
        double all = 0;
        for (std::size_t i = 0; i < object.mask.size(); ++i) {
            held[tree.face[i]] += object.mask[i] != 0 ? 1 : 0;
            all += object.mask[i] != 0 ? 1 : 0;
        }
        for (std::size_t i = tree.faces(); i < tree.nodes.size(); ++i)
            for (const int child : tree.nodes[i].children) held[i] += held[static_cast<std::size_t>(child)];
        const Point point{object.inside[0] + 0.5, object.inside[1] + 0.5};
        const auto pixel = static_cast<std::size_t>(object.inside[1]) * static_cast<std::size_t>(tree.width) +
                           static_cast<std::size_t>(object.inside[0]);
        for (const Silhouette& thing : silhouettes_at(tree, chances, tree.face[pixel])) {
            const double both = held[thing.node] + (thing.other >= 0 ? held[static_cast<std::size_t>(thing.other)] : 0);
            std::vector<float> row{static_cast<float>(number)};
            for (const double feature : features_of(tree, thing, point)) row.push_back(static_cast<float>(feature));
            row.push_back(static_cast<float>(both / (all + thing.bulk.area - both)));
            write(row);
        }
        ++number;
    }
}

// Recipe photo on A4, but for mending, which changes few such pages and those little.
void write_page(const Image& picture, const std::string& map_name, const Truth& truth) {
    Sheet sheet;
    sheet.paper = find_paper("a4", "outline_features");
    sheet.medium = &find_medium("swell", "outline_features");
    Image on_page = picture;
    on_page.mm_per_pixel = place_on(sheet, static_cast<double>(picture.width) / picture.height).drawing.width / picture.width;
    const Recipe to_regions = parse_recipe("resample dpi=50\nnest map=" + map_name + "\n", "regions", filters());
    const Recipe to_lines = parse_recipe("outlines\nsimplify\n", "lines", filters());
    Artwork artwork = tactics::run(to_regions, std::move(on_page));
    const auto& tree = std::get<RegionTree>(artwork);
    const Settings& settings = to_lines.steps.front().settings;
    const ArcChances chances = arc_chances_of(tree);
    const Stakes stakes = stakes_of(tree, chances, settings.number("sure"));
    const Parts parts = parts_of_page(tree, stakes.worth, stakes.price, settings.number("line"));
    const auto features = trust_features_of(tree, parts, chances.drawn);
    if (!features) return;
    const Artwork lines = tactics::run(to_lines, std::move(artwork));
    const PageShares page = Consensus(truth.drawn).shares_of(cut_at(lines_of(lines, picture.width, picture.height), 0));
    std::vector<float> row(features->begin(), features->end());
    for (const double value : {page.p3, page.r3.value_or(-1)}) row.push_back(static_cast<float>(value));
    write(row);
}

void run(const std::string& folder, bool learned, const std::string& what) {
    const auto net = learned ? find_net() : nullptr;
    if (learned && net == nullptr) throw Error(Fault::failed, "nets", "the weights of the contour net are not installed");
    const Pairing pairing = pair_up(files_in(folder + "/images"), files_in(folder + "/gt"));
    int point = 0;
    for (std::size_t number = 0; number < pairing.subjects.size(); ++number) {
        const Subject& subject = pairing.subjects[number];
        Source source = open_source(subject.picture);
        const Image picture = read_picture(source, {0, true});
        Truth truth;
        for (const std::string& path : subject.truths) {
            truth.drawn.push_back(read_truth(path, picture.width, picture.height));
            truth.regions.push_back(regions_between(truth.drawn.back()));
        }
        if (what == "pages") {
            write_page(picture, learned ? "learned" : "plain", truth);
            continue;
        }
        const ContourMaps maps = contour_maps_of(picture, net.get());
        const PairWeights& weights = pair_weights(learned);
        const RegionTree tree = region_tree_of(picture, maps, kLeast, weights);
        if (what == "pairs") {
            write_pairs(picture, maps, tree, weights, truth);
            continue;
        }
        if (what == "points") {
            write_points(tree, truth, point);
            continue;
        }
        const Image copy = copy_of(picture, number);
        write_arcs(tree, region_tree_on(tree.face, copy, contour_maps_of(copy, net.get()), kLeast, weights), truth);
    }
}

}  // namespace

int main(int count, char** words) {
    const std::vector<std::string> given(words + 1, words + count);
    if (given.size() != 3 || (given[1] != "learned" && given[1] != "plain") ||
        (given[2] != "pairs" && given[2] != "arcs" && given[2] != "points" && given[2] != "pages")) {
        std::cerr << "outline_features FOLDER learned|plain pairs|arcs|points|pages > rows\n";
        return 1;
    }
    try {
        run(given[0], given[1] == "learned", given[2]);
    } catch (const Error& error) {
        std::cerr << error.what() << "\n";
        return 2;
    }
    return 0;
}
