// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/play_map.h"

#include <utility>

#include "cli/chain.h"
#include "cli/report/report.h"
#include "cli/report/say.h"
#include "cli/request.h"
#include "cli/table_flags.h"
#include "tactics/error.h"
#include "tactics/units.h"

namespace tactics {

std::optional<double> length_of(const Given& given, std::string_view flag) {
    if (!given.has(flag)) return std::nullopt;
    const auto value = parse_length(given.value(flag));
    if (!value) throw Error(Fault::usage, flag, phrase("it is a length such as 0.5mm"));
    return value;
}

std::optional<double> radius_of(const Given& given) {
    if (!given.has("--radius")) return std::nullopt;
    const double radius = parse_length(given.value("--radius")).value_or(-1);
    if (!(radius >= 0 && radius <= 20)) throw Error(Fault::usage, "--radius", phrase("it is a length from 0 to 20mm"));
    return radius;
}

namespace {

Wishes drawing_of(const Given& given, const Disk& disk) {
    Wishes wishes;
    wishes.chain = read_chain(given, disk);
    if (wishes.chain.base) wishes.recipe = finish(wishes.chain, *wishes.chain.base);
    wishes.table = table_wish(given);
    wishes.page = page_value(given);
    wishes.allowed = allowed_formats(given);
    return wishes;
}

}  // namespace

MapWish map_wish(const Given& given, const Disk& disk) {
    return {{length_of(given, "--pitch"), length_of(given, "--width"), length_of(given, "--low"), length_of(given, "--high")},
            drawing_of(given, disk),
            radius_of(given)};
}

FeltHeights felt_map(Source source, const std::string& path, const MapWish& wish, bool quiet) {
    FeltHeights felt = felt_heights(std::move(source), path, wish.heights, wish.drawing);
    if (wish.best_for) {
        if (felt.drawn)
            throw Error(
                Fault::usage, "--best",
                phrase("{0} is felt as lines, and it is about heights; take --detail best, by which lines are chosen, or --high",
                       path));
        fit_heights(felt.file, *wish.best_for, path);
    }
    if (quiet) return felt;
    for (const Phrase& note : felt.file.notes) say(phrase("{0}: {1}", path, note));
    if (felt.drawn) {
        for (const Phrase& line : choice_lines(*felt.drawn)) say(line);
        for (const Note& note : felt.drawn->notes) say(phrase("{0}: {1}", name_of_input(*felt.drawn), note.words));
    }
    return felt;
}

}  // namespace tactics
