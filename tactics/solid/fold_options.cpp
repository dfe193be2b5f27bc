// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/fold_options.h"

#include <algorithm>
#include <string>

#include "tactics/error.h"

namespace tactics {

namespace {

using enum Option::Type;

constexpr Option kOptions[] = {
    {.name = "plane",
     .type = choice,
     .summary = "plane into which faces are folded: as seen from above, from the front, from the side, from the viewpoint of the "
                "file, or "
                "facing the largest face",
     .choices = "auto above front side view face"},
    {.name = "up",
     .type = choice,
     .summary = "axis of the file that points upwards; file: the one that the file names or its format implies, z for OBJ, PLY "
                "and STL and y for the others",
     .choices = "file z y x"},
    {.name = "fold", .type = choice, .summary = "whether faces are folded out", .choices = "yes no"},
    {.name = "simplify",
     .type = choice,
     .summary = "whether flat things become faces and slender ones lines",
     .choices = "yes no"},
    {.name = "flat",
     .fallback = 0.125,
     .min = 0,
     .max = 1,
     .summary = "greatest ratio of thickness to the next extent for a thing to become a face"},
    {.name = "slender",
     .fallback = 0.125,
     .min = 0,
     .max = 1,
     .summary = "greatest ratio of breadth to length for a thing to "
                "become a line"},
    {.name = "hide", .type = choice, .summary = "whether to leave the thing out", .choices = "no yes"},
    {.name = "hand",
     .fallback = 50,
     .min = 0,
     .max = 1000,
     .unit = "mm",
     .summary = "free space in front of a face that a hand "
                "needs to reach it"},
    {.name = "floor",
     .type = choice,
     .summary = "whether the lowest place stands on a floor, under which no hand can reach",
     .choices = "yes no"},
    {.name = "move", .type = choice, .summary = "whether things may be moved apart", .choices = "yes no"},
    {.name = "effort",
     .type = whole,
     .fallback = 64,
     .min = 0,
     .max = 10'000,
     .summary = "number of layouts to try, of which the best is kept; proportionally fewer for a model of over 200 faces"},
    {.name = "section",
     .fallback = 0,
     .min = 0,
     .max = 1,
     .summary =
         "position of the section among several views, from the front to the back (1); 0: where it cuts most, near the middle"},
    {.name = "cost-fold",
     .fallback = 0.15,
     .min = 0,
     .max = 1,
     .summary = "how hard the reader finds a folded-out face: 1 is as much as a face is worth"},
    {.name = "cost-again", .fallback = 0.4, .min = 0, .max = 1, .summary = "how hard each further fold of that face is"},
    {.name = "cost-flatten", .fallback = 0.1, .min = 0, .max = 1, .summary = "how hard a slender part that was laid flat is"},
    {.name = "cost-turn", .fallback = 0.1, .min = 0, .max = 1, .summary = "how hard a leaning thing that was turned upright is"},
    {.name = "cost-lay", .fallback = 0.15, .min = 0, .max = 1, .summary = "how hard an upright face that was laid down is"},
    {.name = "cost-wedge", .fallback = 0.3, .min = 0, .max = 1, .summary = "how hard a wedge, a line towards the reader, is"},
};

// Of one object alone.
constexpr std::string_view kOfObjects[] = {"fold", "simplify", "flat", "slender", "hide"};

void take_parts(PartWish& parts, const Settings& settings) {
    if (!settings.is_default("simplify")) parts.simplify = settings.choice("simplify") == "yes";
    if (!settings.is_default("flat")) parts.flat = settings.number("flat");
    if (!settings.is_default("slender")) parts.slender = settings.number("slender");
    if (!settings.is_default("hide")) parts.hide = settings.choice("hide") == "yes";
    if (!settings.is_default("fold")) parts.fold = settings.choice("fold") == "yes";
}

FoldPlane plane_named(std::string_view name) {
    for (const FoldPlane plane : {FoldPlane::above, FoldPlane::front, FoldPlane::side, FoldPlane::view, FoldPlane::face})
        if (name == name_of(plane)) return plane;
    return FoldPlane::automatic;
}

}  // namespace

std::span<const Option> fold_options() { return kOptions; }

void take_settings(FoldWish& wish, const Settings& settings, std::string_view path, std::string_view place) {
    if (!path.empty()) {
        for (const Option& option : settings.options())
            if (!settings.is_default(option.name) &&
                std::find(std::begin(kOfObjects), std::end(kOfObjects), option.name) == std::end(kOfObjects))
                throw Error(
                    Fault::usage, std::string(place),
                    phrase("{0} is one for the whole drawing; of one object there are fold, simplify, flat, slender and hide",
                           option.name));
        ObjectWish one{std::string(path), wish.parts};
        take_parts(one.parts, settings);
        wish.objects.push_back(std::move(one));
        return;
    }
    take_parts(wish.parts, settings);
    const auto take = [&](std::string_view name, double& value) {
        if (!settings.is_default(name)) value = settings.number(name);
    };
    if (!settings.is_default("plane")) wish.plane = plane_named(settings.choice("plane"));
    for (const UpAxis up : {UpAxis::x, UpAxis::y, UpAxis::z})
        if (settings.choice("up") == name_of(up)) wish.up = up;
    take("hand", wish.reach.hand);
    if (!settings.is_default("floor")) wish.reach.floor = settings.choice("floor") == "yes";
    if (!settings.is_default("move")) wish.move = settings.choice("move") == "yes";
    if (!settings.is_default("effort")) wish.effort = settings.whole("effort");
    take("section", wish.section);
    take("cost-fold", wish.reader.fold);
    take("cost-again", wish.reader.fold_again);
    take("cost-flatten", wish.reader.flatten);
    take("cost-turn", wish.reader.straighten);
    take("cost-lay", wish.reader.lay);
    take("cost-wedge", wish.reader.wedge);
}

}  // namespace tactics
