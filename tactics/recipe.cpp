// SPDX-License-Identifier: Apache-2.0
#include "tactics/recipe.h"

#include <algorithm>

#include "tactics/error.h"
#include "tactics/text/words.h"

namespace tactics {

Kind kind_of(const Artwork& artwork) {
    if (std::holds_alternative<Image>(artwork)) return Kind::picture;
    if (std::holds_alternative<RegionTree>(artwork)) return Kind::regions;
    return std::holds_alternative<EdgeMap>(artwork) ? Kind::edges : Kind::drawing;
}

std::string_view name_of(Kind kind) {
    switch (kind) {
        case Kind::picture: return "picture";
        case Kind::edges: return "edge map";
        case Kind::regions: return "tree of regions";
        case Kind::drawing: return "drawing";
    }
    return "";
}

const Filter* find_filter(FilterList list, std::string_view name) {
    for (const Filter* filter : list)
        if (filter->name == name) return filter;
    return nullptr;
}

namespace {

bool accepts(const Filter& filter, Kind kind) {
    return contains(filter.takes, kind) || (kind == Kind::edges && contains(filter.takes, Kind::picture));
}

// What the filter works on when `kind` comes to it.
Kind seen_as(const Filter& filter, Kind kind) { return contains(filter.takes, kind) ? kind : Kind::picture; }

Kind after(const Filter& filter, Kind kind) { return filter.gives == 0 ? kind : static_cast<Kind>(filter.gives); }

Phrase mend(const Filter& filter, Kind kind) {
    if (kind == Kind::drawing) return phrase("put it before trace or outlines");
    if (kind == Kind::regions) return phrase("put outlines before it");
    if (contains(filter.takes, Kind::regions)) return phrase("put nest before it");
    if (contains(filter.takes, Kind::drawing)) return phrase("put trace before it");
    return phrase("put sobel, canny or contours before it");
}

}  // namespace

Step parse_step(std::string_view line, std::string_view place, FilterList filters) {
    const auto words = words_of(line);
    if (words.empty()) throw Error(Fault::usage, place, phrase("a filter's name is missing; see tactics list filters"));
    const Filter* filter = find_filter(filters, words[0]);
    if (filter == nullptr) {
        std::vector<std::string_view> names;
        for (const Filter* f : filters) names.push_back(f->name);
        throw Error(Fault::usage, place,
                    phrase("there is no filter \"{0}\"{1}; see tactics list filters", words[0].substr(0, 80),
                           did_you_mean(words[0], names)));
    }
    Step step{filter, Settings(filter->options), std::string(place)};
    for (std::size_t i = 1; i < words.size(); ++i) {
        const auto equals = words[i].find('=');
        if (equals == std::string_view::npos || equals == 0)
            throw Error(Fault::usage, place,
                        phrase("\"{0}\" is not a setting; write NAME=VALUE without spaces around =", words[i].substr(0, 80)));
        const auto name = words[i].substr(0, equals);
        const auto same = [&](std::string_view word) { return word.substr(0, word.find('=')) == name; };
        step.settings.set(name, words[i].substr(equals + 1), place, filter->name);
        if (std::any_of(words.begin() + 1, words.begin() + static_cast<std::ptrdiff_t>(i), same))
            throw Error(Fault::usage, place, phrase("{0} {1} is set twice; set it once", filter->name, name));
    }
    return step;
}

Recipe parse_recipe(std::string_view text, std::string_view origin, FilterList filters) {
    Recipe recipe;
    recipe.name = std::string(origin);
    if (text.size() > kMaxRecipeBytes)
        throw Error(Fault::usage, origin, phrase("this is too long for a recipe (over 64 KiB); is it another kind of file?"));
    if (text.find('\0') != std::string_view::npos)
        throw Error(Fault::usage, origin, phrase("this is not a text file; a recipe is plain text, one filter a line"));
    for (std::size_t at = 0, number = 1; at < text.size(); ++number) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        std::string_view line = text.substr(at, end - at);
        at = end + 1;
        const auto hash = line.find('#');
        if (number == 1 && hash != std::string_view::npos) {
            const auto from = line.find_first_not_of(kBlanks, hash + 1);
            const auto to = line.find_last_not_of(kBlanks);
            if (from != std::string_view::npos) recipe.summary = std::string(line.substr(from, to - from + 1));
        }
        line = line.substr(0, hash);
        if (line.find_first_not_of(kBlanks) == std::string_view::npos) continue;
        const std::string place = std::string(origin) + ":" + std::to_string(number);
        if (recipe.steps.size() == kMaxRecipeSteps)
            throw Error(Fault::usage, place, phrase("a recipe has at most 100 filters; split the work in two"));
        recipe.steps.push_back(parse_step(line, place, filters));
    }
    if (recipe.steps.empty()) throw Error(Fault::usage, origin, phrase("there is no filter in this recipe"));
    return recipe;
}

std::string to_text(const Recipe& recipe) {
    std::string text;
    if (!recipe.summary.empty()) text += "# " + recipe.summary + "\n";
    for (const auto& step : recipe.steps) {
        text += step.filter->name;
        const std::string settings = step.settings.to_text();
        if (!settings.empty()) text += " " + settings;
        text += "\n";
    }
    return text;
}

Kind check(const Recipe& recipe) {
    Kind kind = Kind::picture;
    for (const auto& step : recipe.steps) {
        if (!accepts(*step.filter, kind))
            throw Error(Fault::usage, step.place,
                        phrase("{0} does not work on a {1}, which is what it gets here; {2}", step.filter->name, name_of(kind),
                               mend(*step.filter, kind)));
        kind = after(*step.filter, seen_as(*step.filter, kind));
    }
    return kind;
}

bool uses_colour(const Recipe& recipe) {
    for (const auto& step : recipe.steps) {
        if (!step.filter->uses_colour) continue;
        const auto& options = step.filter->options;
        const auto is_colour = [](const Option& option) { return option.name == "colour"; };
        if (std::none_of(options.begin(), options.end(), is_colour) || step.settings.choice("colour") == "yes") return true;
    }
    return false;
}

namespace {

// As that step takes it.
Artwork seen_by(const Step& step, Artwork artwork) {
    if (!contains(step.filter->takes, kind_of(artwork)) && kind_of(artwork) == Kind::edges)
        artwork = to_picture(std::get<EdgeMap>(artwork));
    return artwork;
}

}  // namespace

Artwork run(const Recipe& recipe, Artwork artwork, const StepWatcher& watcher) {
    for (std::size_t i = 0; i < recipe.steps.size(); ++i) {
        const Step& step = recipe.steps[i];
        if (watcher) watcher(i);
        artwork = step.filter->apply(seen_by(step, std::move(artwork)), step.settings);
    }
    return artwork;
}

Artwork run_settling(Recipe& recipe, Artwork artwork, std::vector<ChosenSetting>& said) {
    for (Step& step : recipe.steps) {
        artwork = seen_by(step, std::move(artwork));
        if (step.filter->settle != nullptr)
            if (ChosenSetting chosen = step.filter->settle(artwork, step.settings); !chosen.empty()) {
                chosen.filter = step.filter->name;
                said.push_back(std::move(chosen));
            }
        artwork = step.filter->apply(std::move(artwork), step.settings);
    }
    return artwork;
}

}  // namespace tactics
