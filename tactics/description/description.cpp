// SPDX-License-Identifier: Apache-2.0
#include "tactics/description/description.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>

#include "tactics/description/object_words.h"
#include "tactics/description/thing_words.h"
#include "tactics/geometry/shape.h"
#include "tactics/layout/room.h"
#include "tactics/layout/scale_bar.h"
#include "tactics/layout/texture.h"
#include "tactics/layout/title.h"
#include "tactics/units.h"

namespace tactics {

namespace {

// What a listener can keep in mind.
constexpr std::size_t kMostThings = 7;
constexpr std::size_t kMostWords = 12;   // labels that are read out
constexpr std::size_t kMostSpoken = 20;  // named things in an alternative text, which nobody can leaf through

Rect both(const Rect& a, const Rect& b) {
    const double left = std::min(a.left, b.left), top = std::min(a.top, b.top);
    return {left, top, std::max(a.left + a.width, b.left + b.width) - left, std::max(a.top + a.height, b.top + b.height) - top};
}

bool ends_a_sentence(std::string_view text) { return text.ends_with('.') || text.ends_with('?') || text.ends_with('!'); }

std::string sheet_words(const Page& page) {
    constexpr double kSame = 0.5;  // mm
    const auto exact = [](double mm) { return to_text(std::round(mm) / 10) + " cm"; };
    const std::string size = exact(page.width) + " wide and " + exact(page.height) + " high";
    for (const Paper& paper : papers()) {
        const bool upright = std::abs(paper.width - page.width) < kSame && std::abs(paper.height - page.height) < kSame;
        const bool across = std::abs(paper.width - page.height) < kSame && std::abs(paper.height - page.width) < kSame;
        if (!upright && !across) continue;
        std::string name(paper.name);
        if (name[0] >= 'a' && name[0] <= 'z')
            name[0] = static_cast<char>(name[0] - 'a' + 'A');
        else
            name += " inch";
        return name + (upright ? " portrait, " : " landscape, ") + size;
    }
    return size;
}

// "most of them in the lower left and the middle": the ninths that hold a good part of them.
std::string mostly(const std::array<double, 9>& shares, const std::string& whom, const std::string& frame) {
    const double all = std::accumulate(shares.begin(), shares.end(), 0.0);
    if (!(all > 0)) return "";
    constexpr double kGoodPart = 0.22, kMost = 0.5;  // an even spread gives each ninth 0.11
    std::vector<std::string> names;
    double held = 0;
    for (std::size_t i = 0; i < 9; ++i)
        if (shares[i] >= kGoodPart * all) {
            names.push_back("the " + std::string(kNinths[i]));
            held += shares[i];
        }
    return held < kMost * all ? ", spread over the " + frame : ", most of " + whom + " in " + listed(names);
}

std::string picture_words(const Page& page) {
    const Bitmap& picture = *page.picture;
    const Ninths ninths(picture.place, "picture"), sheet({0, 0, page.width, page.height}, "page");
    std::array<double, 9> black{};
    double all = 0;
    const double pixel = picture.place.width / picture.width;
    for (int y = 0; y < picture.height; ++y) {
        const std::uint8_t* row = picture.bits.data() + picture.row_bytes() * static_cast<std::size_t>(y);
        const double down = picture.place.top + (y + 0.5) * picture.place.height / picture.height;
        for (std::size_t x = 0; x < picture.row_bytes(); ++x)
            if (row[x] != 0) {
                const double right = picture.place.left + (static_cast<double>(x) * 8 + 4) * pixel;
                black[ninths.of(Point{right, down})] += std::popcount(row[x]);
                all += std::popcount(row[x]);
            }
    }
    const double share = 100 * all / (static_cast<double>(picture.width) * picture.height);
    if (!(all > 0)) return "";
    return "A picture of dots, " + spoken_size(picture.place) + ", " + sheet.place(picture.place) + ": " +
           (share < 1 ? "less than 1" : to_text(std::round(share))) + " percent of it is raised" +
           mostly(black, "it", "picture") + ".";
}

// All of it: whoever reads the words instead of the page has no other.
std::string key_words(const Page& page) {
    std::string entries;
    for (const PageName& name : page.names) entries += (entries.empty() ? "" : "; ") + name.key + " is " + name.text;
    return "On it is the key to the drawing: " + entries + (ends_a_sentence(entries) ? "" : ".");
}

void add_writing(const Page& page, const Ninths& ninths, std::vector<std::string>& sentences) {
    const bool title = !page.print.empty() && shows(page.print.front(), page.title);
    std::vector<std::string> labels;
    std::size_t all = page.names.size();
    for (std::size_t i = title ? 1 : 0; i < page.print.size(); ++i) {
        if (i < 2 && shows(page.print[i], page.caption)) continue;
        const Point at = page.print[i].baseline;
        if (page.scale && distance(nearest_of(page.scale->place, at), at) == 0) continue;  // told below
        ++all;
        if (labels.size() < kMostWords)
            labels.push_back("\"" + page.print[i].text + "\" in the " + kNinths[ninths.of(page.print[i].baseline)]);
    }
    for (std::size_t i = 0; !page.is_key && i < page.names.size() && labels.size() < kMostWords; ++i) {
        const PageName& name = page.names[i];
        labels.push_back("\"" + name.text + "\" in the " + kNinths[ninths.of(name.place.middle())] +
                         (name.key.empty() ? "" : " as the letters " + name.key + ", which the key explains"));
    }
    const std::size_t cells = std::accumulate(page.braille.begin(), page.braille.end(), std::size_t{0},
                                              [](std::size_t sum, const BrailleLine& line) { return sum + line.cells.size(); });
    if (title || !page.title.empty()) {
        const std::string how = title && cells > 0 ? "in print and in braille"
                                : title            ? "in print"
                                : cells > 0        ? "in braille"
                                                   : "";
        if (!how.empty()) sentences.push_back("The title stands at the top " + how + ".");
    }
    if (!page.caption.empty()) sentences.push_back("Caption: " + page.caption + (ends_a_sentence(page.caption) ? "" : "."));
    if (page.scale)
        sentences.push_back("The scale bar in the " + std::string(kNinths[ninths.of(page.scale->place)]) + ", " +
                            spoken_length(page.scale->length) + " long, stands for " + page.scale->text +
                            ": 1 cm on the page is " + real_length(10 * page.scale->real / page.scale->length) + ".");
    if (const std::size_t more = all - labels.size(); !labels.empty())
        sentences.push_back("Words on the page: " + listed(labels) + (more > 0 ? ", and " + std::to_string(more) + " more" : "") +
                            ".");
    if (cells > 0)
        sentences.push_back("Braille: " + counted(page.braille.size(), "line") + " with " + counted(cells, "cell") + ".");
}

std::string rest_words(const std::vector<Wordless>& rest, const Ninths& ninths) {
    if (rest.empty()) return "";
    std::array<double, 9> shares{};
    double lines = 0, longest = 0;  // mm
    std::size_t areas = 0;
    for (const Wordless& one : rest) {
        shares[ninths.of(one.box)] += one.length;
        if (one.area) {
            ++areas;
            continue;
        }
        lines += one.length;
        longest = std::max(longest, one.length);
    }
    std::vector<std::string> parts;
    if (const std::size_t count = rest.size() - areas; count > 1)
        parts.push_back(counted(count, "more line") + ", " + spoken_length(lines) + " together, none longer than " +
                        spoken_length(longest));
    else if (count == 1)
        parts.push_back("1 more line, " + spoken_length(lines) + " long");
    if (areas > 0) parts.push_back(counted(areas, "more filled area"));
    const bool one = rest.size() == 1;
    return std::string(one ? "There is " : "There are ") + listed(parts) +
           (one ? ", " + ninths.place(rest[0].box) : mostly(shares, "them", "drawing")) + ".";
}

// How many lines and areas of each kind.
std::vector<std::string> amounts_of(const Page& page, const std::vector<Wordless>& all) {
    const auto count = [&](bool area) {
        return static_cast<std::size_t>(std::count_if(all.begin(), all.end(), [&](const Wordless& c) { return c.area == area; }));
    };
    std::vector<std::string> parts;
    if (const std::size_t lines = count(false); lines > 0) {
        double length = 0;
        for (const Wordless& one : all) length += one.area ? 0 : one.length;
        parts.push_back(counted(lines, "line") + ", " + spoken_length(length) + (lines > 1 ? " together" : " long"));
    }
    if (const std::size_t areas = count(true) - page.textured.size(); areas > 0) parts.push_back(counted(areas, "filled area"));
    for (int texture = 1; texture <= static_cast<int>(textures().size()); ++texture)
        if (const auto areas =
                std::count_if(page.textured.begin(), page.textured.end(), [&](const Area& a) { return a.texture == texture; });
            areas > 0)
            parts.push_back(counted(static_cast<std::size_t>(areas), "area") + " of " + std::string(name_of_texture(texture)));
    return parts;
}

// The longest, then those that come first in the page; what closes is a thing of its own and counts twice. Those that are left
// are given back.
std::vector<Wordless> keep_longest(const Page& page, std::vector<Wordless>& all) {
    const auto weight = [&](const Wordless& c) { return c.area || page.strokes[c.index].closed ? 2 * c.length : c.length; };
    const std::size_t most = std::min(all.size(), kMostThings);
    std::partial_sort(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(most), all.end(),
                      [&](const Wordless& a, const Wordless& b) {
                          if (weight(a) != weight(b)) return weight(a) > weight(b);
                          return a.area != b.area ? b.area : a.index < b.index;
                      });
    std::vector<Wordless> rest(all.begin() + static_cast<std::ptrdiff_t>(most), all.end());
    all.resize(most);
    return rest;
}

void sort_to_read(std::vector<Wordless>& all, const Ninths& ninths) {
    std::sort(all.begin(), all.end(), [&](const Wordless& a, const Wordless& b) {
        const std::size_t cell = ninths.of(a.box), other = ninths.of(b.box);
        if (cell != other) return cell < other;
        const Point p{a.box.left + a.box.width / 2, a.box.top + a.box.height / 2};
        const Point q{b.box.left + b.box.width / 2, b.box.top + b.box.height / 2};
        if (p.y != q.y) return p.y < q.y;
        if (p.x != q.x) return p.x < q.x;
        return a.area != b.area ? b.area : a.index < b.index;
    });
}

}  // namespace

Description describe(const Page& page) {
    Description description;
    description.title = page.title;
    description.sheet = sheet_words(page);

    std::vector<Wordless> all = candidates_of(page);
    const std::vector<std::string> parts = amounts_of(page, all);
    const std::string picture = page.picture ? picture_words(page) : "";
    // Places are those within the drawing, which is told by its place on the page. A thing alone is the drawing.
    const Ninths sheet({0, 0, page.width, page.height}, "page");
    Rect drawing = all.empty() ? Rect{} : all[0].box;
    for (const Wordless& one : all) drawing = both(drawing, one.box);
    const Ninths ninths = all.size() > 1 ? Ninths(drawing, "drawing") : sheet;
    if (!parts.empty()) description.amounts.push_back("On it: " + listed(parts) + ".");
    if (all.size() > 1)
        description.amounts.push_back("The drawing is " + spoken_size(drawing) + ", " + sheet.place(drawing) +
                                      (sheet.place(drawing).ends_with("page") ? "." : " of the page."));
    description.amounts.insert(description.amounts.end(), page.remarks.begin(), page.remarks.end());
    description.objects = object_sentences(page);
    if (!picture.empty()) description.amounts.push_back(picture);
    if (page.is_key)
        description.amounts.push_back(key_words(page));
    else if (parts.empty() && picture.empty())
        description.amounts.push_back(page.print.empty() && page.braille.empty() ? "The page is empty."
                                                                                 : "Besides the writing the page is empty.");
    add_writing(page, sheet, description.amounts);

    const std::vector<Wordless> rest = keep_longest(page, all);
    sort_to_read(all, ninths);
    double thinnest = 0;
    for (const PageStroke& stroke : page.strokes)
        if (stroke.role != Role::pattern) thinnest = thinnest > 0 ? std::min(thinnest, stroke.width) : stroke.width;
    std::vector<Shape> shapes;
    for (const Wordless& one : all) shapes.push_back(shape_of(page, one));
    for (std::size_t i = 0; i < all.size(); ++i) {
        description.things.push_back(thing_of(page, all[i], shapes[i], ninths, thinnest));
        description.things.back().relations = relations_of(description.things, shapes);
    }
    description.rest = rest_words(rest, ninths);
    return description;
}

std::vector<std::string> lines_of(const Description& description) {
    std::vector<std::string> lines;
    if (!description.title.empty())
        lines.push_back("Title: " + description.title + (ends_a_sentence(description.title) ? "" : "."));
    lines.push_back("Page: " + description.sheet + ".");
    for (const std::string& sentence : description.amounts) lines.push_back(sentence);
    if (!description.objects.empty()) lines.push_back("What it shows:");
    lines.insert(lines.end(), description.objects.begin(), description.objects.end());
    const std::size_t count = description.things.size();
    if (count > 1)
        lines.push_back((description.rest.empty() ? "From" : "The " + std::to_string(count) + " main ones, from") +
                        " top to bottom:");
    for (std::size_t i = 0; i < count; ++i) {
        const Thing& thing = description.things[i];
        lines.push_back((count > 1 ? std::to_string(i + 1) + ". " : "") + thing.what + ", " + thing.place + "." +
                        (thing.relations.empty() ? "" : " " + thing.relations));
    }
    if (!description.rest.empty()) lines.push_back(description.rest);
    return lines;
}

std::string alternative_text(const Page& page, Description description) {
    if (!page.description.empty()) return page.description;
    description.title.clear();
    if (description.objects.size() > kMostSpoken) {
        const std::size_t more = description.objects.size() - kMostSpoken;
        description.objects.resize(kMostSpoken);
        description.objects.push_back("And " + std::to_string(more) + " more.");
    }
    std::string text;
    for (const std::string& line : lines_of(description)) text += (text.empty() ? "" : " ") + line;
    return text;
}

std::string alternative_language(const Page& page) { return page.description.empty() ? "en" : page.language; }

}  // namespace tactics
