// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/own_page.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "tactics/layout/own_layers.h"
#include "tactics/layout/own_marks.h"
#include "tactics/layout/pattern.h"
#include "tactics/layout/words_anew.h"
#include "tactics/readers/svg/found_mark.h"
#include "tactics/readers/svg/own_course.h"
#include "tactics/readers/svg/own_texts.h"
#include "tactics/readers/svg/own_told.h"
#include "tactics/readers/svg/svg_size.h"

namespace tactics {

namespace {

// A table of the user's own is a file of this machine, which a stranger's page may not choose.
bool is_file(const std::string& table) { return table.find('/') != std::string::npos; }

// Things with the numbers that they had on the page; those that are new come behind.
template <typename Thing>
class Numbered {
public:
    void add(std::optional<std::size_t> number, Thing thing) { all_.push_back({number.value_or(SIZE_MAX), std::move(thing)}); }
    std::vector<Thing> finish() {
        std::stable_sort(all_.begin(), all_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
        std::vector<Thing> out;
        for (auto& one : all_) out.push_back(std::move(one.second));
        return out;
    }

private:
    std::vector<std::pair<std::size_t, Thing>> all_;
};

// Print that had no room ends in an ellipsis; the words go on behind it if only what stands there was changed.
std::string whole_of(const std::string& typed, std::string_view shown, const std::string& said) {
    constexpr std::string_view kCut = "\u2026";
    if (!shown.ends_with(kCut) || !typed.ends_with(kCut)) return typed;
    shown.remove_suffix(kCut.size());
    if (!std::string_view(said).starts_with(shown)) return typed;
    return typed.substr(0, typed.size() - kCut.size()) + said.substr(shown.size());
}

class OwnReader {
public:
    OwnReader(const Element& root, const std::string& file, Page page) : root_(root), file_(file), page_(std::move(page)) {}

    OwnPage run() {
        found_ = read_marked_svg(root_, file_, marks_);
        take_size();
        RestTold rest = rest_told(root_);
        page_.words = std::move(rest.words);
        page_.names = std::move(rest.names);
        page_.left_out = std::move(rest.left_out);
        page_.remarks = {rest.remarks.begin(), rest.remarks.end()};  // in the language of the page already
        for (auto& [number, region] : rest.undrawn) regions_.add(number, std::move(region));
        for (const FoundMark& mark : marks_) take(mark);
        take_strays();
        page_.strokes = strokes_.finish();
        page_.areas = areas_.finish();
        page_.textured = textured_.finish();
        page_.regions = regions_.finish();
        page_.braille = braille_.finish();
        put_on_steps(page_);
        take_texts();
        drop_lost_words();
        check_changes();
        change_words();
        keep_on_paper();
        draw_patterns_anew();
        if (is_file(page_.braille_table)) {
            notes_.push_back(
                phrase("its braille is in a table of somebody's own, which is not looked for; name it with {0} to set "
                       "words anew",
                       spelled("braille")));
            page_.braille_table.clear();
        }
        return {std::move(page_), std::move(notes_)};
    }

private:
    // A person may have made the page larger, or fitted it to the drawing.
    void take_size() {
        const SvgSize size = size_of_svg(root_, file_, std::nullopt);
        to_mm_ = size.to_mm;
        const auto take = [](double& side, double now) {
            if (std::abs(side - now) > kUnmoved) side = now;
        };
        take(page_.width, size.width);
        take(page_.height, size.height);
        // What is told of the drawing's place is of the page as it was.
        if (distance(to_mm_(Point{}), Point{}) > kUnmoved) page_.drawing = {};
    }

    void take(const FoundMark& mark) {
        if (mark.layer == marks::kCheckLayer) return;
        const auto number = number_told(*mark.element, marks::kNumber);
        take_strokes(mark, number);
        for (std::size_t i = mark.before.areas; i < mark.behind.areas; ++i) areas_.add(number, found_.page.areas[i]);
        for (std::size_t i = mark.before.textured; i < mark.behind.textured; ++i) textured_.add(number, found_.page.textured[i]);
        for (std::size_t i = mark.before.regions; i < mark.behind.regions; ++i) take_region(mark, found_.page.regions[i]);
        for (std::size_t i = mark.before.braille; i < mark.behind.braille; ++i) take_braille(mark, found_.page.braille[i]);
        if (mark.behind.pictures > mark.before.pictures) take_picture(mark);
    }

    void take_strokes(const FoundMark& mark, std::optional<std::size_t> number) {
        const std::size_t count = mark.behind.strokes - mark.before.strokes;
        if (count == 0) return;
        const double least = width_in_layer(marks::kInner, page_.medium);
        for (std::size_t i = mark.before.strokes; i < mark.behind.strokes; ++i) {
            PageStroke stroke = found_.page.strokes[i];
            if (!number) {
                fresh_ = true;
                if (stroke.role == Role::line) stroke.role = role_in_layer(mark.layer);
                // The pen of a drawing program is a hair's breadth.
                if (stroke.width < least) stroke.width = width_in_layer(mark.layer, page_.medium);
            } else if (count == 1) {
                if (auto points = course_told(mark, stroke)) stroke.points = std::move(*points);
            }
            stroke.width = std::max(stroke.width, least);
            stroke.inner = stroke.role == Role::line && mark.layer == marks::kInner;
            strokes_.add(number, std::move(stroke));
        }
    }

    void take_region(const FoundMark& mark, Region region) {
        if (const auto at = point_told(*mark.element, marks::kAt))
            if (const Point now = mark.transform(*at); holds(region, now)) region.at = now;
        region.counts = counts_told(mark.element->attribute(marks::kCounts));
        regions_.add(number_told(*mark.element, marks::kRegion), std::move(region));
    }

    void take_braille(const FoundMark& mark, BrailleLine line) {
        const auto words = number_told(*mark.element, marks::kWords);
        if (words && *words < page_.words.size()) line.words = static_cast<int>(*words);
        if (const auto at = point_told(*mark.element, marks::kAt)) {
            const Point now = mark.transform(*at);
            if (distance(now, line.first_dot) < 2 * kUnmoved) line.first_dot = distance(now, *at) < kUnmoved ? *at : now;
            if (distance(line.first_dot, *at) >= kUnmoved && line.words >= 0)
                moved_.emplace(line.words, Point{line.first_dot.x - at->x, line.first_dot.y - at->y});
        }
        braille_.add(number_told(*mark.element, marks::kNumber), std::move(line));
    }

    void take_picture(const FoundMark& mark) {
        page_.picture = found_.page.picture;
        const auto told = numbers_told(*mark.element, marks::kAt, 4);
        if (!told) return;
        const Rect was{(*told)[0], (*told)[1], (*told)[2], (*told)[3]};
        const Rect& now = page_.picture->place;
        const bool same = std::abs(was.left - now.left) < kUnmoved && std::abs(was.top - now.top) < kUnmoved &&
                          std::abs(was.width - now.width) < kUnmoved && std::abs(was.height - now.height) < kUnmoved;
        if (same) page_.picture->place = was;
    }

    // Dots of braille that were changed, and what has no element of its own.
    void take_strays() {
        std::vector<bool> line(found_.page.braille.size(), false), stroke(found_.page.strokes.size(), false);
        for (const FoundMark& mark : marks_) {
            for (std::size_t i = mark.before.braille; i < mark.behind.braille; ++i) line[i] = true;
            for (std::size_t i = mark.before.strokes; i < mark.behind.strokes; ++i) stroke[i] = true;
        }
        for (std::size_t i = 0; i < line.size(); ++i)
            if (!line[i]) braille_.add(std::nullopt, found_.page.braille[i]);
        for (std::size_t i = 0; i < stroke.size(); ++i)
            if (!stroke[i]) strokes_.add(std::nullopt, found_.page.strokes[i]);
    }

    // Each change looks through the page.
    void check_changes() const {
        constexpr std::size_t kMost = 1000;
        if (added_.size() + retyped_.size() + text_moved_.size() + moved_.size() > kMost)
            throw Error(Fault::failed, file_,
                        phrase("over {0} of its texts were changed; make the page anew with these words", std::to_string(kMost)));
    }

    void take_texts() {
        Numbered<PrintLine> print;
        for (const OwnText& text : own_texts(root_, to_mm_)) {
            const Element& element = *text.element;
            if (element.attribute(marks::kText).empty()) {
                if (!text.text.empty()) added_.push_back(text);
                continue;
            }
            const auto words = number_told(element, marks::kWords), number = number_told(element, marks::kNumber);
            const auto told = numbers_told(element, marks::kAt, 3);
            if (!told) continue;
            const bool known = words && *words < page_.words.size();
            const Point was{(*told)[0], (*told)[1]}, place = text.transform(was);
            // Its place is exact where it is moved by a group around it or by its own transform.
            const Point at = distance(place, text.at) < kUnmoved ? place : text.at, moved{at.x - was.x, at.y - was.y};
            const bool stands = std::hypot(moved.x, moved.y) < kUnmoved;
            const bool typed = text.text != element.attribute(marks::kText);
            if (typed && known)
                retyped_[static_cast<int>(*words)] =
                    whole_of(text.text, element.attribute(marks::kText), page_.words[*words].text);
            if (number) {
                PrintLine line{stands ? was : at, (*told)[2], typed ? text.text : std::string(element.attribute(marks::kText))};
                if (known) line.words = static_cast<int>(*words);
                if (!line.text.empty()) print.add(number, std::move(line));
            } else if (known && !stands) {
                text_moved_[static_cast<int>(*words)] = moved;
            }
        }
        page_.print = print.finish();
    }

    // Words whose lines are all gone were taken out; of a key the words go with their letters.
    void drop_lost_words() {
        std::vector<bool> set(page_.words.size(), false);
        for (const BrailleLine& line : page_.braille)
            if (line.words >= 0) set[static_cast<std::size_t>(line.words)] = true;
        for (const PrintLine& line : page_.print)
            if (line.words >= 0) set[static_cast<std::size_t>(line.words)] = true;
        std::erase_if(page_.names,
                      [&](const PageName& name) { return name.words >= 0 && !set[static_cast<std::size_t>(name.words)]; });
        const auto has_letters = [&](const PageWords& key) {
            for (std::size_t i = 0; i < page_.words.size(); ++i)
                if (set[i] && page_.words[i].kind == WordsKind::letters && page_.words[i].key == key.key) return true;
            return false;
        };
        lost_.assign(page_.words.size(), false);
        for (std::size_t i = 0; i < page_.words.size(); ++i)
            lost_[i] = !set[i] && !(page_.words[i].kind == WordsKind::key && has_letters(page_.words[i]));
    }

    void change_words() {
        for (const auto& [words, by] : text_moved_)
            if (moved_.find(words) == moved_.end() && !lost_[static_cast<std::size_t>(words)])
                move_words(page_, words, by.x, by.y);
        // Their braille is there already.
        for (const auto& [words, by] : moved_) follow_words(page_, words, by.x, by.y);
        for (const auto& [words, text] : retyped_) {
            if (lost_[static_cast<std::size_t>(words)] || text.empty()) continue;
            if (Phrase note = set_words_anew(page_, words, text); !note.empty()) notes_.push_back(std::move(note));
        }
        for (const OwnText& text : added_) add_words(page_, text.at, text.text);
        for (std::size_t i = 0; i < lost_.size(); ++i) {
            if (!lost_[i]) continue;
            if (page_.words[i].kind == WordsKind::title) page_.title.clear();
            if (page_.words[i].kind == WordsKind::caption) page_.caption.clear();
            page_.words[i].kind = WordsKind::label;  // nobody sets it
        }
        drop_unset_words(page_);
    }

    // Where an area or what its pattern gives way to has changed. What was taken out leaves the gap that was kept for it.
    void draw_patterns_anew() {
        const std::string was(root_.attribute(marks::kTextured));
        const bool same = page_.textured.empty() ? was.empty() : was == mark_of(page_.textured);
        const bool gives_way = fresh_ || !moved_.empty() || !text_moved_.empty() || !retyped_.empty() || !added_.empty();
        if (same && (page_.textured.empty() || !gives_way)) return;
        std::erase_if(page_.strokes, [](const PageStroke& stroke) { return stroke.role == Role::pattern; });
        draw_patterns(page_, *sheet_of(page_).medium);
        put_on_steps(page_);
    }

    // All of it to one side of the sheet.
    bool is_beside(const std::vector<Point>& points) const {
        const auto all = [&](const auto& test) { return std::all_of(points.begin(), points.end(), test); };
        return all([](Point p) { return p.x < 0; }) || all([](Point p) { return p.y < 0; }) ||
               all([&](Point p) { return p.x > page_.width; }) || all([&](Point p) { return p.y > page_.height; });
    }

    // What no format can have: a place beside the sheet.
    void keep_on_paper() {
        const std::size_t drawn = page_.strokes.size() + page_.areas.size() + page_.textured.size();
        std::erase_if(page_.strokes, [&](const PageStroke& stroke) { return is_beside(stroke.points); });
        for (auto* areas : {&page_.areas, &page_.textured}) {
            for (Area& area : *areas) std::erase_if(area.rings, [&](const auto& ring) { return is_beside(ring); });
            std::erase_if(*areas, [](const Area& area) { return area.rings.empty(); });
        }
        if (page_.strokes.size() + page_.areas.size() + page_.textured.size() < drawn)
            notes_.push_back(phrase("lines or areas that lie beside the page are left out; move them onto it"));
        const auto put = [&](Point& p) { p = {std::clamp(p.x, 0.0, page_.width), std::clamp(p.y, 0.0, page_.height)}; };
        for (PageStroke& stroke : page_.strokes)
            for (Point& p : stroke.points) put(p);
        for (auto* areas : {&page_.areas, &page_.textured})
            for (Area& area : *areas)
                for (auto& ring : area.rings)
                    for (Point& p : ring) put(p);
        const std::size_t lines = page_.braille.size(), print = page_.print.size();
        const auto lies_off = [&](Point p) { return !(p.x >= 0 && p.x <= page_.width && p.y >= 0 && p.y <= page_.height); };
        std::erase_if(page_.braille, [&](const BrailleLine& line) { return lies_off(line.first_dot); });
        std::erase_if(page_.print, [&](const PrintLine& line) { return lies_off(line.baseline); });
        if (page_.braille.size() < lines || page_.print.size() < print)
            notes_.push_back(phrase("words that stand beside the page are left out; move them onto it"));
    }

    const Element& root_;
    const std::string& file_;
    Page page_;
    FoundPage found_;
    std::vector<FoundMark> marks_;
    Transform to_mm_;
    Numbered<PageStroke> strokes_;
    Numbered<Area> areas_, textured_;
    Numbered<Region> regions_;
    Numbered<BrailleLine> braille_;
    std::map<int, Point> moved_, text_moved_;  // words whose braille, or whose text, was moved
    std::map<int, std::string> retyped_;
    std::vector<OwnText> added_;
    std::vector<bool> lost_;  // of the words
    bool fresh_ = false;      // there are lines that it had not
    std::vector<Phrase> notes_;
};

}  // namespace

std::optional<OwnPage> read_own_page(std::string_view bytes, const std::string& file) {
    if (bytes.find(marks::kVersion) == std::string_view::npos) return std::nullopt;
    const Element root = parse_xml(bytes, file);
    std::optional<Page> page = page_told(root);
    if (!page) return std::nullopt;
    return OwnReader(root, file, std::move(*page)).run();
}

}  // namespace tactics
