// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/best_detail.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "filters/drawing_of.h"
#include "filters/line_budget.h"
#include "tactics/error.h"
#include "tactics/information/agreed_lines.h"
#include "tactics/job/mending.h"
#include "tactics/medium.h"
#include "tactics/text/table.h"
#include "tactics/units.h"

namespace tactics {

namespace {

// Half octaves: who has half as much line notices, who has a tenth more does not.
constexpr double kTimes[] = {0.25, 0.35, 0.5, 0.7, 1, 1.4, 2, 2.8, 4};
constexpr double kFull = 16;  // of the usual line: all that anybody would draw
// Losses that differ by less are about equal: what is known of people's lines is known no better.
constexpr double kSameLoss = 0.02;
constexpr float kCertain = 255;

std::size_t budget_step(const Recipe& recipe) {
    const auto step =
        std::find_if(recipe.steps.begin(), recipe.steps.end(), [](const Step& one) { return !one.filter->budget.empty(); });
    return static_cast<std::size_t>(step - recipe.steps.begin());
}

double usual_line(const Step& step) { return step.settings.number(step.filter->budget); }

// The nearest amount that the filter takes.
double taken_line(const Step& step, double line) {
    const auto options = step.settings.options();
    const auto option =
        std::find_if(options.begin(), options.end(), [&](const Option& each) { return each.name == step.filter->budget; });
    return std::clamp(line, option->min, option->max);
}

void set_line(Step& step, double line) {
    step.settings.set(step.filter->budget, to_text(taken_line(step, line)), spelled("detail"), step.filter->name);
}

// From little to much, each once: at the limits of the filter several become one.
std::vector<double> tried_times(const Step& step) {
    const double usual = usual_line(step);
    std::vector<double> all;
    for (const double times : kTimes) {
        const double line = taken_line(step, times * usual), taken = line == times * usual ? times : line / usual;
        if (all.empty() || taken > all.back()) all.push_back(taken);
    }
    return all;
}

// What people would draw of it: each line has its chance as its strength.
double agreed_length(const Drawing& drawing) {
    double agreed = 0;
    for (const Stroke& stroke : drawing.strokes)
        agreed += length_of(stroke) * static_cast<double>(std::min(stroke.strength, kCertain) / kCertain);
    return agreed;
}

class Trying {
public:
    Trying(const Recipe& recipe, Artwork picture, const Sheet& sheet, const Rect& place, bool as_drawn)
        : sheet_(sheet), place_(place), as_drawn_(as_drawn) {
        const auto from = recipe.steps.begin() + static_cast<std::ptrdiff_t>(budget_step(recipe));
        rest_.steps.assign(from, recipe.steps.end());
        usual_ = usual_line(rest_.steps.front());
        Recipe before;
        before.steps.assign(recipe.steps.begin(), from);
        found_ = run(before, std::move(picture));
        const double apart = least_apart(*sheet.medium, sheet.medium->line, sheet.medium->line);
        lines_.room = place.width * place.height / apart;
        lines_.followed = line_budget(usual_, place.width, place.height);
        lines_.wanted = agreed_length(scaled_to(drawn(kFull), place.width));
    }

    TriedDetail at(double times) const {
        const Mended mended = mend_for(*sheet_.medium, place_.width, drawn(times), as_drawn_);
        TriedDetail tried{.times = times, .line = total_stroke_length(mended.drawing), .broken = mended.told.broken_after};
        if (!mended.told.complete) ++tried.broken;
        AgreedLines lines = lines_;
        lines.drawn = tried.line;
        lines.agreed = agreed_length(mended.drawing);
        lines.wanted = std::max(lines.wanted, lines.agreed);
        if (tried.line > 0) tried.agreed = lines.agreed / tried.line;
        tried.loss = agreed_bits(lines).loss();
        return tried;
    }

private:
    Drawing drawn(double times) const {
        Recipe recipe = rest_;
        set_line(recipe.steps.front(), times * usual_);
        return drawing_of(run(recipe, found_));
    }

    const Sheet& sheet_;
    const Rect& place_;
    bool as_drawn_;
    Recipe rest_;  // from the step with the budget on
    double usual_ = 0;
    Artwork found_;  // what that is given
    AgreedLines lines_;
};

const TriedDetail& usual_of(const std::vector<TriedDetail>& tried) {
    return *std::find_if(tried.begin(), tried.end(), [](const TriedDetail& one) { return one.times == 1; });
}

std::size_t best_of(const std::vector<TriedDetail>& tried) {
    const auto worse = [](const TriedDetail& a, const TriedDetail& b) {
        return a.broken != b.broken ? a.broken > b.broken : a.loss > b.loss;
    };
    const TriedDetail least =
        *std::min_element(tried.begin(), tried.end(), [&](const auto& a, const auto& b) { return worse(b, a); });
    std::size_t best = tried.size();
    const auto change = [&](std::size_t i) { return std::abs(std::log2(tried[i].times)); };
    for (std::size_t i = 0; i < tried.size(); ++i)
        if (tried[i].broken == least.broken && tried[i].loss <= least.loss + kSameLoss &&
            (best == tried.size() || change(i) < change(best)))
            best = i;
    return best;
}

Phrase amount(double times) {
    return times == 1 ? phrase("the usual line") : phrase("{0} times the usual line", numeral(std::round(times * 1000) / 1000));
}

}  // namespace

void check_chooses_detail(const Recipe& recipe) {
    const std::size_t at = budget_step(recipe);
    // Regions know how likely people would draw what parts them; an edge map knows only how strong it is.
    if (at < recipe.steps.size() && recipe.steps[at].filter->takes != static_cast<Kinds>(Kind::regions))
        throw Error(
            Fault::usage, spelled("detail"),
            phrase("the lines of recipe {0} do not say how likely people would draw them, by which best chooses; take {1} "
                   "photo, or a number",
                   recipe.name, spelled("recipe")));
}

DetailChoice choose_detail(Recipe& recipe, Artwork picture, const Sheet& sheet, const Rect& place, bool as_drawn) {
    const Trying trying(recipe, std::move(picture), sheet, place, as_drawn);
    DetailChoice choice;
    Step& step = recipe.steps[budget_step(recipe)];
    for (const double times : tried_times(step)) choice.tried.push_back(trying.at(times));
    choice.best = best_of(choice.tried);
    set_line(step, choice.chosen().times * usual_line(step));
    return choice;
}

Phrase explained(const DetailChoice& choice, const Medium& medium) {
    const TriedDetail& chosen = choice.chosen();
    std::vector<Phrase> others;
    for (const TriedDetail* other : {&choice.tried.front(), &usual_of(choice.tried), &choice.tried.back()})
        if (other != &chosen) others.push_back(phrase("{0}: {1}", amount(other->times), percent(other->loss)));
    return phrase(
        "{0} best takes {1} for {2}, which loses {3} of the bits about what people would draw ({4}); of {5} amounts it is the "
        "nearest to the usual within {6} of the least loss",
        spelled("detail"), amount(chosen.times), medium.name, percent(chosen.loss), row_of(others),
        std::to_string(choice.tried.size()), percent(kSameLoss));
}

Phrase remark_on(const DetailChoice& choice) {
    return phrase("It is drawn with {0}, with which a page of this kind tells most of what people would draw.",
                  amount(choice.chosen().times));
}

}  // namespace tactics
