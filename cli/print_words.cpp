#include "cli/print_words.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "cli/axis_names.h"
#include "tactics/braille.h"
#include "tactics/error.h"
#include "tactics/units.h"

namespace tactics {

namespace {

// What these draw has its words beside its things. In a photograph print is a part of a thing.
constexpr std::array<std::string_view, 3> kForDrawings{"diagram", "map", "line-art"};

std::string percent(double value) { return to_text(std::round(value * 10) / 10); }

bool is_number(std::string_view text) {
    if (text.starts_with("\u2212")) text.remove_prefix(3);
    return parse_number(text).has_value();
}

// A letter that the table has no cells for must not stop the page: a person will know what to do about it.
bool has_braille(const std::string& text, const std::string& table) {
    if (table.empty()) return true;
    try {
        return !to_braille(text, table, "print").empty();
    } catch (const Error&) {
        return false;
    }
}

}  // namespace

WordsWish words_value(const Given& given) {
    const std::string text = given.value("--words", "auto");
    if (text == "auto") return WordsWish::automatic;
    if (text == "read") return WordsWish::read;
    if (text == "leave") return WordsWish::leave;
    if (text == "remove") return WordsWish::remove;
    throw Error(Fault::usage, "--words",
                "it cannot be \"" + text.substr(0, 80) + "\"" + did_you_mean(text, {"auto", "read", "leave", "remove"}) +
                    "; it is auto, read, leave or remove");
}

void PrintWords::take_from(Image& picture) const { take_out(picture, lettering, !remove_all); }

std::vector<Name> PrintWords::names_on(const Drawing& drawing) const {
    std::vector<Name> names;
    for (const ToldWords& words : told)
        if (words.set)
            names.push_back({{words.wanted.x / 100 * drawing.width, words.wanted.y / 100 * drawing.height}, words.text,
                             "the print at " + percent(words.x) + " %, " + percent(words.y) + " %"});
    return names;
}

PrintWords words_of(Reading& reading, const Recipe& recipe, WordsWish wish, const Sheet& sheet) {
    PrintWords words;
    if (wish == WordsWish::leave) return words;
    const bool asked = wish != WordsWish::automatic;
    const bool for_drawings = std::find(kForDrawings.begin(), kForDrawings.end(), recipe.name) != kForDrawings.end();
    const bool whole = draws_whole(recipe) && !sheet.bare;
    if (!asked && (!for_drawings || !whole)) return words;
    if (!whole) throw Error(Fault::usage, "--words", "print is read in whole pages only; leave out --words, or --bare and the filter crop");
    Lettering& lettering = words.lettering = read_lettering(reading.get({kLookForWords, false}), sheet.language, kSureEnough);
    if (!lettering.trouble.empty()) {
        if (asked) throw Error(Fault::failed, "--words", "there is print in the picture; " + lettering.trouble);
        words.notes.push_back("print in it is left in the lines; " + lettering.trouble);
    }
    words.remove_all = wish == WordsWish::remove;
    std::vector<PrintPlace> places;
    for (PrintedWords& one : lettering.words) {
        if (one.sure && !words.remove_all) one.sure = has_braille(one.text, sheet.braille_table);
        const double x = 50.0 * (one.box.left + one.box.right) / lettering.width;
        const double y = 50.0 * (one.box.top + one.box.bottom) / lettering.height;
        words.told.push_back({one.text, one.sureness, x, y, one.sure && !words.remove_all});
        places.push_back({{x, y}, 100.0 * one.letter_height / lettering.height, one.upwards, is_number(one.text)});
    }
    place_axis_names(places, 100);
    for (std::size_t i = 0; i < places.size(); ++i) words.told[i].wanted = {places[i].at.x, std::min(places[i].at.y, 100.0)};
    const auto set = std::count_if(words.told.begin(), words.told.end(), [](const ToldWords& one) { return one.set; });
    if (set > 0)
        words.notes.push_back("print was read at " + std::to_string(set) + (set == 1 ? " place" : " places") +
                              " and stands in braille; look it over, or leave it as it is with --words leave");
    if (!words.remove_all)
        for (const ToldWords& one : words.told)
            if (!one.set) words.notes.push_back(unsure_line(one));
    return words;
}

std::string unsure_line(const ToldWords& words) {
    const std::string place = percent(words.x) + "%," + percent(words.y) + "%";
    return "print at " + percent(words.x) + " %, " + percent(words.y) + " % was read as \"" + words.text +
           "\" with little sureness (" + to_text(std::round(words.sureness)) + " of 100) and is left in the lines; if it is words, give it with --label \"" +
           place + "=...\"";
}

}  // namespace tactics
