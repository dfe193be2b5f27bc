// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/recipe_wish.h"

#include <algorithm>
#include <cmath>

#include "filters/list.h"
#include "print/format.h"
#include "tactics/error.h"
#include "tactics/units.h"

namespace tactics {

namespace {

std::vector<std::string_view> step_names(const Recipe& recipe) {
    std::vector<std::string_view> names;
    for (const Step& step : recipe.steps) names.push_back(step.filter->name);
    return names;
}

void set_in_all(Recipe& recipe, const Change& change) {
    bool found = false;
    for (Step& step : recipe.steps) {
        if (step.filter->name != change.name) continue;
        step.settings.set(change.option, change.value, change.place, change.name);
        found = true;
    }
    if (found) return;
    const auto names = step_names(recipe);
    std::string all;
    for (const auto name : names) all += (all.empty() ? "" : ", ") + std::string(name);
    throw Error(
        Fault::usage, change.place,
        phrase("recipe {0} has no filter {1}{2}; it has {3}", recipe.name, change.name, did_you_mean(change.name, names), all));
}

bool names_setting(std::string_view line, std::string_view option) {
    return line.find(" " + std::string(option) + "=") != std::string_view::npos;
}

// The step that draws every contour in its place; nothing: no step does. Throws if a requested setting does not exist in it.
std::optional<Step> in_full(const Step& step, const std::vector<Change>& changes) {
    std::optional<Step> full;
    if (step.filter->in_full != "-") full = parse_step(step.filter->in_full, spelled("detail"), filters());
    const auto has = [&](std::string_view name) {
        return full && std::any_of(full->filter->options.begin(), full->filter->options.end(),
                                   [&](const Option& option) { return option.name == name; });
    };
    for (const Option& option : step.filter->options)
        if (has(option.name) && !names_setting(step.filter->in_full, option.name))
            full->settings.set(option.name, step.settings.text(option.name), spelled("detail"), full->filter->name);
    for (const Change& change : changes) {
        if (change.name != step.filter->name) continue;
        if (!has(change.option))
            throw Error(
                Fault::usage, change.place,
                phrase("{0} contours draws every contour, without {1}, so {1}.{2} would do nothing; leave out one of the two",
                       spelled("detail"), change.name, change.option));
        full->settings.set(change.option, change.value, change.place, full->filter->name);
    }
    return full;
}

// The lines of a recipe that leave something out give way to those that do not.
void draw_every_contour(Recipe& recipe, const std::vector<Change>& changes) {
    std::vector<Step> steps;
    for (Step& step : recipe.steps) {
        if (step.filter->in_full.empty())
            steps.push_back(std::move(step));
        else if (std::optional<Step> full = in_full(step, changes))
            steps.push_back(std::move(*full));
    }
    recipe.steps = std::move(steps);
}

// So many times the line that the step has.
void multiply_line(Step& step, const std::string& detail, const std::string& recipe) {
    const std::string_view budget = step.filter->budget;
    const double line = step.settings.number(budget);
    const auto options = step.settings.options();
    const auto option = std::find_if(options.begin(), options.end(), [&](const Option& each) { return each.name == budget; });
    // To three decimals within the range, so that what the message offers is accepted.
    const double least = std::ceil(option->min / line * 1000) / 1000;
    const double most = std::floor(option->max / line * 1000) / 1000;
    const double times = parse_number(detail).value_or(1);
    if (times < least || times > most)
        throw Error(Fault::usage, spelled("detail"),
                    phrase("{0} is out of range; with recipe {1} it is {2} to {3} times the line that touch allows",
                           detail.substr(0, 80), recipe, to_text(least), to_text(most)));
    step.settings.set(budget, to_text(line * times), spelled("detail"), step.filter->name);
}

std::vector<Step>::iterator find_budget(Recipe& recipe) {
    return std::find_if(recipe.steps.begin(), recipe.steps.end(), [](const Step& step) { return !step.filter->budget.empty(); });
}

std::string named_budgets() {
    std::string names;
    for (const Filter* filter : filters())
        if (!filter->budget.empty()) names += (names.empty() ? "" : " or ") + std::string(filter->name);
    return names;
}

// touch: the recipe's own amount; contours: every contour that it finds, even fine ones and ones that a finger cannot tell apart;
// a number: that many times the recipe's line budget.
void set_detail(Recipe& recipe, const RecipeWish& chain) {
    const std::string& detail = chain.detail;
    if (detail.empty()) return;
    const auto budget = find_budget(recipe);
    if (budget == recipe.steps.end() && !chain.base) return;  // auto took a recipe that keeps everything
    if (budget == recipe.steps.end())
        throw Error(Fault::usage, spelled("detail"),
                    phrase("recipe {0} has no filter that keeps to a budget of line, such as {1}; leave {2} out or use {3} photo",
                           recipe.name, named_budgets(), spelled("detail"), spelled("recipe")));
    if (detail == "touch" || detail == "best") return;
    if (detail == "contours") return draw_every_contour(recipe, chain.changes);
    multiply_line(*budget, detail, recipe.name);
}

// Makes the result printable. `gives`: by check().
void make_printable(Recipe& recipe, Kind gives) {
    const bool cut =
        std::any_of(recipe.steps.begin(), recipe.steps.end(), [](const Step& step) { return step.filter->cuts_edges; });
    if (gives == Kind::edges && cut) return;
    for (const Filter* filter : filters())
        if (contains(filter->finishes, gives)) recipe.steps.push_back(parse_step(filter->name, filter->name, filters()));
}

// The resolution at which a picture is processed.
void give_resolution(Recipe& recipe) {
    if (std::any_of(recipe.steps.begin(), recipe.steps.end(), [](const Step& step) { return !step.filter->dpi.empty(); })) return;
    for (const Filter* filter : filters())
        if (!filter->dpi.empty()) recipe.steps.insert(recipe.steps.begin(), parse_step(filter->name, filter->name, filters()));
}

Recipe with_wishes(const RecipeWish& chain, Recipe recipe, bool printable) {
    recipe.steps.insert(recipe.steps.end(), chain.added.begin(), chain.added.end());
    give_resolution(recipe);
    const Kind gives = check(recipe);              // before any step is interpreted by its predecessors
    if (printable) make_printable(recipe, gives);  // before settings, which may belong to the appended steps
    for (const Change& change : chain.changes) set_in_all(recipe, change);
    set_detail(recipe, chain);
    check(recipe);
    return recipe;
}

}  // namespace

Change parse_change(std::string_view text, std::string_view place) {
    const auto equals = text.find('=');
    const auto dot = text.substr(0, equals).find('.');
    if (equals == std::string_view::npos || dot == std::string_view::npos || dot == 0 || dot + 1 == equals)
        throw Error(Fault::usage, place,
                    phrase("\"{0}\" is not a setting; write NAME.OPTION=VALUE, for example png.dpi=300", text.substr(0, 80)));
    Change change{std::string(text.substr(0, dot)), std::string(text.substr(dot + 1, equals - dot - 1)),
                  std::string(text.substr(equals + 1)), std::string(place)};
    // Tried on a copy, so that mistakes are reported before any picture is opened.
    if (const Filter* filter = find_filter(filters(), change.name)) {
        Settings(filter->options).set(change.option, change.value, place, change.name);
        return change;
    }
    if (const Format* format = find_format(change.name)) {
        Settings(format->options).set(change.option, change.value, place, change.name);
        return change;
    }
    std::vector<std::string_view> names;
    for (const Filter* filter : filters()) names.push_back(filter->name);
    for (const Format* format : formats()) names.push_back(format->name);
    throw Error(Fault::usage, place,
                phrase("there is no filter or format \"{0}\"{1}; see tactics list filters formats", change.name.substr(0, 80),
                       did_you_mean(change.name, names)));
}

void check_detail(const std::string& detail) {
    if (!parse_number(detail)) return;
    Recipe photo = find_recipe("photo", spelled("detail"));
    multiply_line(*find_budget(photo), detail, photo.name);
}

bool keeps_some(const Recipe& recipe) {
    return std::any_of(recipe.steps.begin(), recipe.steps.end(), [](const Step& step) { return !step.filter->budget.empty(); });
}

bool asks_for_a_way(const RecipeWish& wish) {
    return wish.base || !wish.added.empty() || !wish.changes.empty() || !wish.detail.empty();
}

Recipe assemble(const RecipeWish& chain, Recipe base) { return with_wishes(chain, std::move(base), false); }

Recipe finish(const RecipeWish& chain, Recipe base) { return with_wishes(chain, std::move(base), true); }

}  // namespace tactics
