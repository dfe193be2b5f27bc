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
#include "tactics/layout/kind_words.h"
#include "tactics/layout/room.h"
#include "tactics/layout/scale_bar.h"
#include "tactics/layout/texture.h"
#include "tactics/layout/title.h"
#include "tactics/text/catalogue.h"

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

// A sentence that ends with words of the user's has one mark at its end.
std::string ended(const std::string& text) { return ends_a_sentence(text) ? text : text + "."; }

Phrase sheet_words(const Page& page) {
    constexpr double kSame = 0.5;  // mm
    const auto exact = [](double mm) { return phrase("{0} cm", numeral(std::round(mm) / 10)); };
    Phrase size = phrase("{0} wide and {1} high", exact(page.width), exact(page.height));
    for (const Paper& paper : papers()) {
        const bool upright = std::abs(paper.width - page.width) < kSame && std::abs(paper.height - page.height) < kSame;
        const bool across = std::abs(paper.width - page.height) < kSame && std::abs(paper.height - page.width) < kSame;
        if (!upright && !across) continue;
        const bool named = paper.name[0] >= 'a' && paper.name[0] <= 'z';
        Phrase name = named ? Phrase(as_sentence(std::string(paper.name))) : phrase("{0} inch", paper.name);
        return upright ? phrase("{0} portrait, {1}", std::move(name), std::move(size))
                       : phrase("{0} landscape, {1}", std::move(name), std::move(size));
    }
    return size;
}

// The ninths that hold a good part of what is shared out; none if it is spread over all.
std::vector<Phrase> good_parts(const std::array<double, 9>& shares) {
    const double all = std::accumulate(shares.begin(), shares.end(), 0.0);
    constexpr double kGoodPart = 0.22, kMost = 0.5;  // an even spread gives each ninth 0.11
    std::vector<Phrase> names;
    double held = 0;
    for (std::size_t i = 0; i < 9; ++i)
        if (shares[i] >= kGoodPart * all) {
            names.push_back(name_of_ninth(i));
            held += shares[i];
        }
    if (held < kMost * all) names.clear();
    return names;
}

Phrase picture_words(const Page& page) {
    const Bitmap& picture = *page.picture;
    const Ninths ninths(picture.place), sheet({0, 0, page.width, page.height});
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
    if (!(all > 0)) return {};
    const std::vector<Phrase> parts = good_parts(black);
    return phrase("A picture of dots, {0}, {1}: {2} percent of it is raised, {3}.", spoken_size(picture.place),
                  sheet.place(picture.place), share < 1 ? phrase("less than 1") : numeral(std::round(share)),
                  parts.empty() ? phrase("spread over the picture") : phrase("most of it in {0}", listed(parts)));
}

// All of it: whoever reads the words instead of the page has no other.
Phrase key_words(const Page& page) {
    Phrase entries;
    for (std::size_t i = 0; i < page.names.size(); ++i) {
        const PageName& name = page.names[i];
        Phrase entry = phrase("{0} is {1}", name.key, i + 1 < page.names.size() ? name.text : ended(name.text));
        entries = i == 0 ? std::move(entry) : phrase("{0}; {1}", std::move(entries), std::move(entry));
    }
    return phrase("On it is the key to the drawing: {0}", std::move(entries));
}

// What is said of the words at their places, and how many there are.
std::vector<Phrase> labels_of(const Page& page, const Ninths& ninths, bool title, std::size_t& all) {
    std::vector<Phrase> labels;
    all = page.names.size();
    for (std::size_t i = title ? 1 : 0; i < page.print.size(); ++i) {
        if (i < 2 && shows(page.print[i], page.caption)) continue;
        const Point at = page.print[i].baseline;
        if (page.scale && distance(nearest_of(page.scale->place, at), at) == 0) continue;  // told below
        ++all;
        if (labels.size() < kMostWords)
            labels.push_back(phrase("\"{0}\" {1}", page.print[i].text, ninths.place(page.print[i].baseline)));
    }
    for (std::size_t i = 0; !page.is_key && i < page.names.size() && labels.size() < kMostWords; ++i) {
        const PageName& name = page.names[i];
        const Phrase place = ninths.place(name.place.middle());
        labels.push_back(name.key.empty()
                             ? phrase("\"{0}\" {1}", name.text, place)
                             : phrase("\"{0}\" {1} as the letters {2}, which the key explains", name.text, place, name.key));
    }
    return labels;
}

void add_writing(const Page& page, const Ninths& ninths, std::vector<Phrase>& sentences) {
    const bool title = !page.print.empty() && shows(page.print.front(), page.title);
    std::size_t all = 0;
    const std::vector<Phrase> labels = labels_of(page, ninths, title, all);
    const std::size_t cells = std::accumulate(page.braille.begin(), page.braille.end(), std::size_t{0},
                                              [](std::size_t sum, const BrailleLine& line) { return sum + line.cells.size(); });
    if (title)
        sentences.push_back(cells > 0 ? phrase("The title stands at the top in print and in braille.")
                                      : phrase("The title stands at the top in print."));
    else if (!page.title.empty() && cells > 0)
        sentences.push_back(phrase("The title stands at the top in braille."));
    if (!page.caption.empty()) sentences.push_back(phrase("Caption: {0}", ended(page.caption)));
    if (page.scale)
        sentences.push_back(phrase("The scale bar {0}, {1} long, stands for {2}: 1 cm on the page is {3}.",
                                   ninths.place(page.scale->place.middle()), spoken_length(page.scale->length), page.scale->text,
                                   real_length(10 * page.scale->real / page.scale->length)));
    if (const std::size_t more = all - labels.size(); !labels.empty())
        sentences.push_back(more > 0 ? phrase("Words on the page: {0}, and {1} more.", listed(labels), std::to_string(more))
                                     : phrase("Words on the page: {0}.", listed(labels)));
    if (cells > 0)
        sentences.push_back(phrases(page.braille.size(), "Braille: {0} line with {1}.", "Braille: {0} lines with {1}.",
                                    phrases(cells, "{0} cell", "{0} cells")));
}

Phrase rest_words(const std::vector<Wordless>& rest, const Ninths& ninths) {
    if (rest.empty()) return {};
    std::array<double, 9> shares{};
    double lines = 0, longest = 0, all = 0;  // mm
    std::size_t areas = 0;
    for (const Wordless& one : rest) {
        shares[ninths.of(one.box)] += one.length;
        all += one.length;
        if (one.area) {
            ++areas;
            continue;
        }
        lines += one.length;
        longest = std::max(longest, one.length);
    }
    std::vector<Phrase> parts;
    if (const std::size_t count = rest.size() - areas; count > 0)
        parts.push_back(phrases(count, "{0} more line, {1} long", "{0} more lines, {1} together, none longer than {2}",
                                spoken_length(lines), spoken_length(longest)));
    if (areas > 0) parts.push_back(phrases(areas, "{0} more filled area", "{0} more filled areas"));
    if (rest.size() == 1) return phrase("There is {0}, {1}.", listed(parts), ninths.place(rest[0].box));
    if (!(all > 0)) return phrase("There are {0}.", listed(parts));
    const std::vector<Phrase> most = good_parts(shares);
    return most.empty() ? phrase("There are {0}, spread over the drawing.", listed(parts))
                        : phrase("There are {0}, most of them in {1}.", listed(parts), listed(most));
}

// How many lines and areas of each kind.
std::vector<Phrase> amounts_of(const Page& page, const std::vector<Wordless>& all) {
    const auto count = [&](bool area) {
        return static_cast<std::size_t>(std::count_if(all.begin(), all.end(), [&](const Wordless& c) { return c.area == area; }));
    };
    std::vector<Phrase> parts;
    if (const std::size_t lines = count(false); lines > 0) {
        double length = 0;
        for (const Wordless& one : all) length += one.area ? 0 : one.length;
        parts.push_back(phrases(lines, "{0} line, {1} long", "{0} lines, {1} together", spoken_length(length)));
    }
    if (const std::size_t areas = count(true) - page.textured.size(); areas > 0)
        parts.push_back(phrases(areas, "{0} filled area", "{0} filled areas"));
    for (int texture = 1; texture <= static_cast<int>(textures().size()); ++texture)
        if (const auto areas =
                std::count_if(page.textured.begin(), page.textured.end(), [&](const Area& a) { return a.texture == texture; });
            areas > 0)
            parts.push_back(
                phrases(static_cast<std::size_t>(areas), "{0} area of {1}", "{0} areas of {1}", name_of_texture(texture)));
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
    description.language = page.language;
    description.title = page.title;
    description.sheet = sheet_words(page);

    std::vector<Wordless> all = candidates_of(page);
    const std::vector<Phrase> parts = amounts_of(page, all);
    const Phrase picture = page.picture ? picture_words(page) : Phrase();
    // Places are those within the drawing, which is told by its place on the page. A thing alone is the drawing.
    const Ninths sheet({0, 0, page.width, page.height});
    Rect drawing = all.empty() ? Rect{} : all[0].box;
    for (const Wordless& one : all) drawing = both(drawing, one.box);
    const Ninths ninths = all.size() > 1 ? Ninths(drawing, Ninths::Frame::drawing) : sheet;
    if (!parts.empty()) description.amounts.push_back(phrase("On it: {0}.", listed(parts)));
    if (all.size() > 1)
        description.amounts.push_back(phrase("The drawing is {0}, {1}.", spoken_size(drawing), sheet.place_on_page(drawing)));
    if (page.heights.differ()) description.amounts.push_back(phrase("Heights of what is raised: {0}.", words_of(page.heights)));
    description.amounts.insert(description.amounts.end(), page.remarks.begin(), page.remarks.end());
    description.objects = object_sentences(page);
    if (!picture.empty()) description.amounts.push_back(picture);
    if (page.is_key)
        description.amounts.push_back(key_words(page));
    else if (parts.empty() && picture.empty())
        description.amounts.push_back(page.print.empty() && page.braille.empty()
                                          ? phrase("The page is empty.")
                                          : phrase("Besides the writing the page is empty."));
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
    std::vector<Phrase> lines;
    if (!description.title.empty()) lines.push_back(phrase("Title: {0}", ended(description.title)));
    lines.push_back(phrase("Page: {0}.", description.sheet));
    lines.insert(lines.end(), description.amounts.begin(), description.amounts.end());
    if (!description.objects.empty()) lines.push_back(phrase("What it shows:"));
    lines.insert(lines.end(), description.objects.begin(), description.objects.end());
    const std::size_t count = description.things.size();
    if (count > 1)
        lines.push_back(description.rest.empty() ? phrase("From top to bottom:")
                                                 : phrase("The {0} main ones, from top to bottom:", std::to_string(count)));
    std::vector<std::string> texts = in_language(lines, description.language);
    for (std::size_t i = 0; i < count; ++i) {
        const Thing& thing = description.things[i];
        std::string text = count > 1 ? std::to_string(i + 1) + ". " : "";
        text += as_sentence(phrase("{0}, {1}.", thing.what, thing.place).in(description.language));
        if (!thing.relations.empty()) text += " " + as_sentence(thing.relations.in(description.language));
        texts.push_back(std::move(text));
    }
    if (!description.rest.empty()) texts.push_back(description.rest.in(description.language));
    return texts;
}

std::string alternative_text(const Page& page, Description description) {
    if (!page.description.empty()) return page.description;
    description.title.clear();
    if (description.objects.size() > kMostSpoken) {
        const std::size_t more = description.objects.size() - kMostSpoken;
        description.objects.resize(kMostSpoken);
        description.objects.push_back(phrase("And {0} more.", std::to_string(more)));
    }
    std::string text;
    for (const std::string& line : lines_of(description)) text += (text.empty() ? "" : " ") + line;
    return text;
}

std::string alternative_language(const Page& page) {
    return page.description.empty() ? std::string(spoken_language(page.language)) : page.language;
}

}  // namespace tactics
