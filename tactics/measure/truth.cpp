// SPDX-License-Identifier: Apache-2.0
#include "tactics/measure/truth.h"

#include <algorithm>
#include <map>
#include <string_view>

#include "tactics/error.h"
#include "tactics/readers/read.h"

namespace tactics {

namespace {

std::string stem_of(std::string_view path) {
    path.remove_prefix(path.rfind('/') + 1);  // npos + 1 is 0
    return std::string(path.substr(0, path.rfind('.')));
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// "b" of "gt/b_gt12.png", or empty.
std::string picture_of(std::string_view truth) {
    const std::string stem = stem_of(truth);
    const auto at = stem.rfind("_gt");
    if (at == std::string::npos || at + 3 == stem.size()) return "";
    return std::all_of(stem.begin() + static_cast<std::ptrdiff_t>(at) + 3, stem.end(), is_digit) ? stem.substr(0, at) : "";
}

// a_gt2 before a_gt10.
bool by_number(const std::string& a, const std::string& b) { return a.size() != b.size() ? a.size() < b.size() : a < b; }

}  // namespace

Pairing pair_up(std::vector<std::string> pictures, std::vector<std::string> truths) {
    Pairing pairing;
    std::sort(pictures.begin(), pictures.end());
    std::sort(truths.begin(), truths.end(), by_number);
    std::map<std::string, Subject> subjects;
    for (const auto& path : pictures) {
        const std::string name = stem_of(path);
        const auto [subject, fresh] = subjects.emplace(name, Subject{name, path, {}});
        if (!fresh)
            pairing.problems.push_back(phrase("{0}: {1} has the same name, so its contour maps are not known apart; rename one",
                                              path, subject->second.picture));
    }
    for (const auto& path : truths) {
        const std::string name = picture_of(path);
        const auto subject = subjects.find(name);
        if (name.empty())
            pairing.problems.push_back(
                phrase("{0}: this is no contour map by its name; NAME_gt1.png is the first of picture NAME", path));
        else if (subject == subjects.end())
            pairing.problems.push_back(phrase("{0}: there is no picture {1}; add it or take the map away", path, name));
        else
            subject->second.truths.push_back(path);
    }
    for (auto& [name, subject] : subjects) pairing.subjects.push_back(std::move(subject));
    return pairing;
}

PixelSet read_truth(const std::string& path, int width, int height) {
    Source source = open_source(path);
    const Image image = read_picture(source, {0, false});
    if (image.width != width || image.height != height)
        throw Error(
            Fault::failed, path,
            phrase("this contour map has {0} x {1} pixels and its picture {2} x {3}; both must have the same size",
                   std::to_string(image.width), std::to_string(image.height), std::to_string(width), std::to_string(height)));
    PixelSet set{width, height, {}};
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        if (image.pixels[i] != 0) set.pixels.push_back(static_cast<std::uint32_t>(i));
    if (set.pixels.size() > image.pixels.size() / 2)
        throw Error(Fault::failed, path, phrase("more than half of this contour map is line; lines are white on black in it"));
    return set;
}

}  // namespace tactics
