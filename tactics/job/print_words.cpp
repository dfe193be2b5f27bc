// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/print_words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>

#include "filters/first_ink.h"
#include "filters/inked_legend.h"
#include "filters/legend_frame.h"
#include "filters/quieted.h"
#include "tactics/braille/braille.h"
#include "tactics/error.h"
#include "tactics/job/figure_title.h"
#include "tactics/job/label_lines.h"
#include "tactics/job/print_fonts.h"
#include "tactics/layout/sheet.h"
#include "tactics/lettering/two_readings.h"
#include "tactics/units.h"

namespace tactics {

namespace {

// The distance from its place at which the name of an axis needs no lead line, mm. A setting: two braille lines.
constexpr double kLoose = 24;

bool is_one_number(std::string_view text) {
    if (text.starts_with("\u2212")) text.remove_prefix(std::string_view("\u2212").size());
    return parse_number(text).has_value();
}

bool has_braille(const std::string& text, const std::string& table) {
    if (table.empty()) return true;
    try {
        return !to_braille(text, table, "print").empty();
    } catch (const Error&) {
        return false;
    }
}

// "10²" as "10^2", and "H₂O" as "H2O".
std::string with_carets(std::string_view text) {
    constexpr std::string_view kLowered = "\u2080";  // and nine more, up to a last byte 9 higher
    constexpr std::array<std::string_view, 11> kRaised{"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074", "\u2075",
                                                       "\u2076", "\u2077", "\u2078", "\u2079", "\u207b"};
    std::string out;
    bool raised = false;
    while (!text.empty()) {
        if (const char last = text.size() > 2 && text.substr(0, 2) == kLowered.substr(0, 2) ? text[2] : '\0';
            last >= kLowered[2] && last <= kLowered[2] + 9) {
            out += static_cast<char>('0' + (last - kLowered[2]));
            raised = false;
            text.remove_prefix(3);
            continue;
        }
        const auto found =
            std::find_if(kRaised.begin(), kRaised.end(), [&](std::string_view one) { return text.starts_with(one); });
        const bool is_raised = found != kRaised.end();
        if (is_raised && !raised) out += '^';
        raised = is_raised;
        const std::size_t size = is_raised ? found->size() : 1;
        out += is_raised ? "0123456789-"[static_cast<std::size_t>(found - kRaised.begin())] : text.front();
        text.remove_prefix(size);
    }
    return out;
}

std::string tenths(double value) { return to_text(std::round(value * 10) / 10); }

}  // namespace

void want_places(std::vector<ToldWords>& told, std::vector<PrintPlace> places) {
    for (std::size_t i = 0; i < places.size(); ++i) places[i].number = is_one_number(told[i].text);
    place_axis_names(places, 100);
    for (std::size_t i = 0; i < places.size(); ++i) {
        told[i].wanted = places[i].at;
        told[i].loose = places[i].loose;
    }
}

void keep_what_has_braille(std::vector<ToldWords>& told, const std::string& table) {
    const auto lacks = [&](const ToldWords& words) { return words.set && !has_braille(words.text, table); };
    const bool rewrite = std::any_of(
        told.begin(), told.end(), [&](const ToldWords& words) { return lacks(words) && with_carets(words.text) != words.text; });
    for (ToldWords& words : told) {
        if (rewrite) words.text = with_carets(words.text);
        if (lacks(words)) words.set = false;
    }
}

std::vector<ToldWords> without(const std::vector<Name>& left_out, std::vector<ToldWords> told) {
    std::set<std::string_view> origins;
    for (const Name& name : left_out) origins.insert(name.origin);
    for (ToldWords& one : told)
        if (!origins.empty() && origins.count(origin_of(one)) > 0) one.set = false;
    return told;
}

void PrintWords::take_from(Image& picture) const {
    take_out(picture, lettering, !remove_all);
    constexpr int kFades = 2;  // pixels around a sample in which it fades into the ground
    for (const Rect& sample : samples) {
        const auto pixel = [](double percent, int size, int more) {
            return std::clamp(static_cast<int>(std::lround(percent / 100 * size)) + more, 0, size);
        };
        const int left = pixel(sample.left, picture.width, -kFades), top = pixel(sample.top, picture.height, -kFades);
        const int right = pixel(sample.left + sample.width, picture.width, kFades),
                  bottom = pixel(sample.top + sample.height, picture.height, kFades);
        if (left >= right || top >= bottom) continue;
        // Above what is level and left of what is upright: beyond the end of a frame's side its line may go on.
        const bool level = right - left > bottom - top;
        const int beside_x = level ? (left + right) / 2 : std::max(0, left - 1),
                  beside_y = level ? std::max(0, top - 1) : (top + bottom) / 2;
        std::array<std::uint8_t, 3> ground{};
        std::copy_n(picture.row(beside_y) + beside_x * picture.channels, picture.channels, ground.begin());
        for (int y = top; y < bottom; ++y)
            for (int x = left; x < right; ++x)
                std::copy_n(ground.begin(), picture.channels, picture.row(y) + x * picture.channels);
    }
}

bool PrintWords::any_set() const {
    return std::any_of(told.begin(), told.end(), [](const ToldWords& words) { return words.set && !words.title; });
}

std::string origin_of(const ToldWords& words) { return "the print at " + tenths(words.x) + " %, " + tenths(words.y) + " %"; }

std::vector<Name> PrintWords::names_on(const Drawing& drawing, const Rect& part) const {
    std::vector<Name> names;
    for (const ToldWords& words : told)
        if (words.set && !words.title)
            names.push_back({{(words.wanted.x / 100 - part.left) / part.width * drawing.width,
                              (words.wanted.y / 100 - part.top) / part.height * drawing.height},
                             words.text,
                             origin_of(words),
                             words.loose ? kLoose : 0});
    return names;
}

namespace {

// A person must look at each, but of many pictures a line for each picture is enough to send them there.
void add_unsure(Notes& notes, const PrintWords& words) {
    for (const bool out : {false, true}) {
        std::vector<const ToldWords*> left;
        for (std::size_t i = 0; i < words.told.size(); ++i)
            if (const ToldWords& one = words.told[i];
                one.out == out && !one.set && !(words.remove_all && words.lettering.words[i].print))
                left.push_back(&one);
        const std::string count = std::to_string(left.size());
        if (left.size() > 1)
            notes.push_back(to_act_on(
                out ? phrase("print at {0} places was not read for sure and is left out of the lines; look it over, and give "
                             "what is words with {1}",
                             count, spelled("label"))
                    : phrase("print at {0} places was not read for sure and is left in the lines; look it over, and give "
                             "what is words with {1}",
                             count, spelled("label"))));
        for (const ToldWords* one : left)
            notes.push_back({unsure_line(*one), left.size() > 1 ? Note::Kind::know : Note::Kind::act});
    }
}

// Whether that place, in pixels, is of one shade, but for noise.
bool is_even(const Image& grey, const Box& place) {
    constexpr int kLine = 48;  // grey levels
    const int left = std::max(0, static_cast<int>(place.left)), right = std::min(grey.width, static_cast<int>(place.right)),
              top = std::max(0, static_cast<int>(place.top)), bottom = std::min(grey.height, static_cast<int>(place.bottom) + 1);
    int darkest = 255, lightest = 0;
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x) {
            darkest = std::min<int>(darkest, grey.row(y)[x]);
            lightest = std::max<int>(lightest, grey.row(y)[x]);
        }
    return lightest - darkest <= kLine;
}

// What looked like print and is a sample of the legend.
void forget_samples(PrintWords& words) {
    for (std::size_t i = words.told.size(); i-- > 0;) {
        const ToldWords& one = words.told[i];
        if (one.set || std::none_of(words.samples.begin(), words.samples.end(), [&](const Rect& box) {
                return one.x >= box.left && one.x <= box.left + box.width && one.y >= box.top && one.y <= box.top + box.height;
            }))
            continue;
        words.told.erase(words.told.begin() + static_cast<std::ptrdiff_t>(i));
        words.lettering.words.erase(words.lettering.words.begin() + static_cast<std::ptrdiff_t>(i));
    }
}

// It is darker than what is beside it nearly all over, or along all of its sides.
bool is_block(const Image& grey, const PixelBox& box) {
    constexpr double kAllOver = 0.8;
    constexpr int kPaler = 25, kBeside = 3, kSide = 2;  // levels; pixels
    const int y = (box.top + box.bottom) / 2, before = box.left - kBeside, behind = box.right + kBeside;
    if (before < 0 || behind >= grey.width || box.bottom > grey.height || y >= grey.height) return false;
    if (std::min(box.width(), box.height()) <= 2 * kSide) return false;
    const int ground = std::min(grey.row(y)[before], grey.row(y)[behind]);
    const auto is_dark = [&](int left, int top, int right, int bottom) {
        int dark = 0;
        for (int v = top; v < bottom; ++v)
            for (int u = left; u < right; ++u) dark += grey.row(v)[u] < ground - kPaler ? 1 : 0;
        return dark > kAllOver * (right - left) * (bottom - top);
    };
    const auto has_line = [&](int left, int top, int right, int bottom) {
        const bool upright = bottom - top > right - left;
        for (int i = 0; i < kSide; ++i)
            if (upright ? is_dark(left + i, top, left + i + 1, bottom) : is_dark(left, top + i, right, top + i + 1)) return true;
        return false;
    };
    return is_dark(box.left, box.top, box.right, box.bottom) || (has_line(box.left, box.top, box.left + kSide, box.bottom) &&
                                                                 has_line(box.right - kSide, box.top, box.right, box.bottom) &&
                                                                 has_line(box.left, box.top, box.right, box.top + kSide) &&
                                                                 has_line(box.left, box.bottom - kSide, box.right, box.bottom));
}

// Without unread print that is a box: samples of a legend are as large as letters.
Lettering without_blocks(const PrintWords& words, const Image& grey) {
    Lettering print = words.lettering;
    const double across = static_cast<double>(grey.width) / print.width, down = static_cast<double>(grey.height) / print.height;
    std::vector<PrintedWords> kept;
    for (std::size_t i = 0; i < print.words.size(); ++i) {
        const PixelBox& box = print.words[i].box;
        const PixelBox there{static_cast<int>(box.left * across), static_cast<int>(box.top * down),
                             static_cast<int>(box.right * across), static_cast<int>(box.bottom * down)};
        if (words.told[i].set || !words.told[i].text.empty() || !is_block(grey, there)) kept.push_back(std::move(print.words[i]));
    }
    print.words = std::move(kept);
    return print;
}

// Words of a legend stand at what their samples show.
void place_legend(PrintWords& words, Reading& reading) {
    const Lettering& lettering = words.lettering;
    if (words.told.size() < 2) return;
    Image picture = reading.get({kLookForWords, true});
    if (picture.width == 0 || picture.height == 0) return;
    take_out(picture, without_blocks(words, to_grey(picture)), true);
    const double across = static_cast<double>(picture.width) / lettering.width,
                 down = static_cast<double>(picture.height) / lettering.height;
    std::vector<LegendWords> boxes;
    for (std::size_t i = 0; i < words.told.size(); ++i) {
        const PixelBox& box = lettering.words[i].box;
        const bool may = words.told[i].set && !words.told[i].title && !lettering.words[i].upwards;
        boxes.push_back({{static_cast<int>(box.left * across), static_cast<int>(box.top * down),
                          std::min(picture.width, static_cast<int>(box.right * across)),
                          std::min(picture.height, static_cast<int>(box.bottom * down))},
                         may ? lettering.words[i].letter_height * down : 0});
    }
    std::vector<Phrase> told;
    std::vector<PixelBox> legend;
    double height = 0;
    const double x = 100.0 / picture.width, y = 100.0 / picture.height;
    const auto leave_out = [&](const PixelBox& box) {
        words.samples.push_back({box.left * x, box.top * y, box.width() * x, box.height() * y});
    };
    for (const LegendEntry& entry : legend_in(picture, boxes)) {
        words.told[entry.words].wanted = {entry.at.x * x, entry.at.y * y};
        words.told[entry.words].loose = false;
        leave_out(entry.sample);
        legend.insert(legend.end(), {entry.sample, boxes[entry.words].box});
        height = std::max(height, boxes[entry.words].height);
        told.push_back(phrase("\"{0}\"", words.told[entry.words].text));
    }
    forget_samples(words);
    for (const PixelBox& side : legend_frame(picture, legend, height)) leave_out(side);
    if (!told.empty())
        words.notes.push_back(
            phrase("of its legend these words {0} each name what is painted like their sample, and stand there", row_of(told)));
}

void join_lines(PrintWords& words, Reading& reading) {
    const Lettering& lettering = words.lettering;
    std::vector<PlacedLine> lines;
    for (const PrintedWords& one : lettering.words) {
        const Box box{static_cast<double>(one.box.left), static_cast<double>(one.box.top), static_cast<double>(one.box.right),
                      static_cast<double>(one.box.bottom)};
        lines.push_back({box, static_cast<double>(one.letter_height), one.upwards});
    }
    std::optional<Image> left;
    const auto is_free = [&](const Box& place) {
        if (!left) take_out(left.emplace(to_grey(reading.get({kLookForWords, false}))), lettering, true);
        return is_even(*left, place);
    };
    join_label_lines(words.told, lines, {is_free, [](Point, Point) { return false; }});
}

// A noisy picture is read as it is and with its noise smoothed away: each finds letters that the other one lost.
Lettering read_print(const Image& picture, const std::string& language) {
    Lettering given = read_lettering(picture, language, kSureEnough, each_print_font);
    Image grey = to_grey(picture);
    if (!given.trouble.empty() || !quieten_lines(grey)) return given;
    return put_together(std::move(given), read_lettering(grey, language, kSureEnough, each_print_font));
}

}  // namespace

WordsWish find_words_wish(std::string_view name, std::string_view place) {
    if (name == "auto") return WordsWish::automatic;
    if (name == "read") return WordsWish::read;
    if (name == "leave") return WordsWish::leave;
    if (name == "remove") return WordsWish::remove;
    throw Error(Fault::usage, place,
                phrase("it cannot be \"{0}\"{1}; it is auto, read, leave or remove", name.substr(0, 80),
                       did_you_mean(name, {"auto", "read", "leave", "remove"})));
}

PrintWords words_of(Reading& reading, const Recipe& recipe, WordsWish wish, const Sheet& sheet) {
    PrintWords words;
    if (wish == WordsWish::leave) return words;
    const bool asked = wish != WordsWish::automatic;
    const bool whole = draws_whole(recipe) && !sheet.bare;
    if (!asked && (!recipe.has_words || !whole)) return words;
    if (!whole)
        throw Error(Fault::usage, spelled("words"),
                    phrase("print is read in whole pages only; leave out {0}, or {1} and the filter crop", spelled("words"),
                           spelled("bare")));
    Lettering& lettering = words.lettering = read_print(reading.get({kLookForWords, false}), sheet.language);
    if (!lettering.trouble.empty()) {
        if (asked) throw Error(Fault::failed, spelled("words"), phrase("there is print in the picture; {0}", lettering.trouble));
        words.notes.push_back(to_act_on(phrase("print in it is left in the lines; {0}", lettering.trouble)));
    }
    words.remove_all = wish == WordsWish::remove;
    std::vector<PrintPlace> places;
    for (PrintedWords& one : lettering.words) {
        const double x = 50.0 * (one.box.left + one.box.right) / lettering.width;
        const double y = 50.0 * (one.box.top + one.box.bottom) / lettering.height;
        words.told.push_back({one.text, one.sureness, x, y, one.sure && !words.remove_all});
        places.push_back({{x, y}, 100.0 * one.letter_height / lettering.height, one.upwards});
        if (one.at) places.back().at = {100 * one.at->x / lettering.width, 100 * one.at->y / lettering.height};
    }
    keep_what_has_braille(words.told, sheet.braille_table);
    if (sheet.title.empty() && !words.told.empty()) {
        Image picture = to_grey(reading.get({kLookForWords, false}));
        take_out(picture, lettering, true);
        words.title = take_title(words.told, places, first_ink(picture));
    }
    want_places(words.told, std::move(places));
    place_legend(words, reading);
    // What stays in the lines stays there as a whole.
    for (std::size_t i = 0; i < words.told.size(); ++i) {
        PrintedWords& one = lettering.words[i];
        one.out = !words.told[i].set && (one.out || one.sure);
        one.sure = words.told[i].set;
        words.told[i].out = one.out;
    }
    Notes unsure;
    add_unsure(unsure, words);
    join_lines(words, reading);
    const auto set = std::count_if(words.told.begin(), words.told.end(), [](const ToldWords& one) { return one.set; });
    if (set > 0)
        words.notes.push_back(
            phrases(static_cast<std::size_t>(set),
                    "print was read at {0} place and stands in braille; look it over, or leave it as it is with {1} leave",
                    "print was read at {0} places and stands in braille; look it over, or leave it as it is with {1} leave",
                    spelled("words")));
    words.notes.insert(words.notes.end(), unsure.begin(), unsure.end());
    return words;
}

Phrase unsure_line(const ToldWords& words) {
    const std::string x = tenths(words.x), y = tenths(words.y), sureness = to_text(std::round(words.sureness));
    const auto label = spelled("label");
    const bool faint = words.sureness < kSureEnough;
    if (words.out && words.text.empty())
        return phrase(
            "print at {0} %, {1} % was not read and is left out of the lines; give its words with {2} \"{0}%,{1}%=...\"", x, y,
            label);
    if (words.out && !faint)
        return phrase(
            "print at {0} %, {1} % was read as \"{2}\", which a second look did not confirm, and is left out of the lines; give "
            "its words with {3} \"{0}%,{1}%=...\"",
            x, y, words.text, label);
    if (words.out)
        return phrase(
            "print at {0} %, {1} % was read as \"{2}\" with little sureness ({3} of 100) and is left out of the lines; give its "
            "words with {4} \"{0}%,{1}%=...\"",
            x, y, words.text, sureness, label);
    if (words.text.empty())
        return phrase(
            "print at {0} %, {1} % was not read and is left in the lines; if it is words, give it with {2} \"{0}%,{1}%=...\"", x,
            y, label);
    if (!faint)
        return phrase(
            "print at {0} %, {1} % was read as \"{2}\", which a second look did not confirm, and is left in the lines; if it is "
            "words, give it with {3} \"{0}%,{1}%=...\"",
            x, y, words.text, label);
    return phrase(
        "print at {0} %, {1} % was read as \"{2}\" with little sureness ({3} of 100) and is left in the lines; if it is "
        "words, give it with {4} \"{0}%,{1}%=...\"",
        x, y, words.text, sureness, label);
}

}  // namespace tactics
