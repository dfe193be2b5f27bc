// SPDX-License-Identifier: Apache-2.0
#include "studies/matching_report.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "tactics/text/json.h"
#include "tactics/text/table.h"
#include "tactics/units.h"

namespace tactics {

namespace {

// The results of the pilot study (J. P. Fritz, T. P. Way, K. E. Barner, section 2), on sets of about nine sheets.
struct Found {
    std::string_view recipe;
    std::string_view rate;
};
constexpr Found kPaper[] = {
    {"none", "0.12"}, {"kmeans", "0.60-0.80"}, {"sobel", "0.60-0.80"}, {"kmeans-sobel", "over 0.70"}, {"sobel-kmeans", "0.97"},
};
constexpr std::array<std::array<std::size_t, 2>, 5> kOrder{{{0, 1}, {0, 2}, {1, 3}, {2, 3}, {3, 4}}};  // worse, better
constexpr std::string_view kOrderText = "none, then kmeans and sobel, then kmeans-sobel, then sobel-kmeans";

double rate_of(const MatchingStudy& study, const MatchedRecipe& recipe) {
    return static_cast<double>(recipe.hits()) / static_cast<double>(study.trials());
}

struct Means {
    double ink = 0, length = 0;
    Counts contours;
};

Means means_of(const MatchedRecipe& recipe) {
    Means means;
    for (const SheetFacts& sheet : recipe.sheets) {
        means.ink += sheet.ink / static_cast<double>(recipe.sheets.size());
        means.length += sheet.length / static_cast<double>(recipe.sheets.size());
        means.contours += sheet.contours;
    }
    return means;
}

std::string paper_rate(std::string_view recipe) {
    for (const Found& found : kPaper)
        if (found.recipe == recipe) return std::string(found.rate);
    return "";
}

double middle_of_unsorted(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

// The paper's five recipes in its order, or nothing if one was not requested.
std::vector<const MatchedRecipe*> papers_five(const MatchingStudy& study) {
    std::vector<const MatchedRecipe*> five;
    for (const Found& found : kPaper)
        for (const MatchedRecipe& recipe : study.recipes)
            if (recipe.name == found.recipe) {
                five.push_back(&recipe);
                break;
            }
    if (five.size() < std::size(kPaper)) five.clear();
    return five;
}

bool order_holds(const std::vector<const MatchedRecipe*>& five, std::size_t reader) {
    return std::all_of(kOrder.begin(), kOrder.end(),
                       [&](const auto& pair) { return five[pair[0]]->random[reader] < five[pair[1]]->random[reader]; });
}

std::vector<std::size_t> readers_of_the_order(const MatchingStudy& study) {
    std::vector<std::size_t> held;
    const auto five = papers_five(study);
    for (std::size_t i = 0; !five.empty() && i < study.random_readers.size(); ++i)
        if (order_holds(five, i)) held.push_back(i);
    return held;
}

std::string exceptions_to_the_order(const MatchingStudy& study) {
    const auto five = papers_five(study);
    std::string text;
    for (const auto& [worse, better] : kOrder) {
        const double low = rate_of(study, *five[worse]), high = rate_of(study, *five[better]);
        if (low < high) continue;
        text += (text.empty() ? "" : "; ") + five[better]->name + " " + fixed(high, 2) + " is not above " + five[worse]->name +
                " " + fixed(low, 2);
    }
    return text;
}

std::string range_text(const ReaderRange& range, double least, double most) {
    const std::string unit = range.unit.empty() ? "" : " " + std::string(range.unit);
    return std::string(range.name) + " " + fixed(least, 2) + (least == most ? "" : " to " + fixed(most, 2)) + unit;
}

std::string reader_text(const FingertipReader& reader) {
    std::string text;
    for (const ReaderRange& range : reader_ranges())
        text += (text.empty() ? "" : ", ") + std::string(range.name) + " " + to_text(range.get(reader)) +
                (range.unit.empty() ? "" : " " + std::string(range.unit));
    return text;
}

std::string order_lines(const MatchingStudy& study) {
    if (papers_five(study).empty()) return "";
    const std::string exceptions = exceptions_to_the_order(study);
    std::string text = "The paper's order (" + std::string(kOrderText) + ") ";
    text += exceptions.empty() ? "comes out with the usual reader.\n"
                               : "does not come out with the usual reader: " + exceptions + ".\n";
    const auto held = readers_of_the_order(study);
    text += "Under " + std::to_string(study.random_readers.size()) + " readers with parameters at random it comes out in " +
            std::to_string(held.size()) + " (" +
            percent(static_cast<double>(held.size()) / static_cast<double>(study.random_readers.size())) + ")";
    std::string drawn, there;
    for (const ReaderRange& range : reader_ranges()) {
        drawn += (drawn.empty() ? "" : ", ") + range_text(range, range.least, range.most);
        double least = range.most, most = range.least;
        for (const std::size_t i : held) {
            least = std::min(least, range.get(study.random_readers[i]));
            most = std::max(most, range.get(study.random_readers[i]));
        }
        there += (there.empty() ? "" : ", ") + range_text(range, least, most);
    }
    text += held.empty() ? ".\n" : ": with " + there + ".\n";
    return text + "They were drawn from " + drawn + ".\n";
}

// A line for each change, a column for each recipe.
std::string changes_text(const MatchingStudy& study) {
    std::vector<Row> rows{{"one parameter changed"}};
    for (const MatchedRecipe& recipe : study.recipes) rows[0].push_back(recipe.name);
    for (std::size_t i = 0; i < study.changed_readers.size(); ++i) {
        rows.push_back({study.changed_readers[i].change});
        for (const MatchedRecipe& recipe : study.recipes) rows.back().push_back(fixed(recipe.changed[i], 2));
    }
    for (Row& row : rows) row.emplace_back();  // the last column of a table starts at the left
    return aligned(std::move(rows));
}

std::string hardest(const MatchingStudy& study, const MatchedRecipe& recipe) {
    std::vector<std::size_t> order(study.pictures.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return recipe.sheets[a].hits < recipe.sheets[b].hits; });
    std::string text;
    for (std::size_t i = 0; i < std::min<std::size_t>(order.size(), 3); ++i)
        text += (i > 0 ? ", " : "") + study.pictures[order[i]] + " " +
                fixed(static_cast<double>(recipe.sheets[order[i]].hits) / study.readers, 2);
    return text;
}

std::string mistakes_text(const MatchingStudy& study, const MatchedRecipe& recipe) {
    std::string text;
    for (std::size_t i = 0; i < std::min<std::size_t>(recipe.mistakes.size(), 3); ++i) {
        const Mistake& mistake = recipe.mistakes[i];
        text += (i > 0 ? ", " : "; most often taken for another: ") + study.pictures[mistake.picture] + " for " +
                study.pictures[mistake.taken_for] + " " + std::to_string(mistake.times) + " of " + std::to_string(study.readers);
    }
    return text;
}

std::string sets_text(const MatchingStudy& study) {
    const auto [least, most] = std::minmax_element(study.sets.begin(), study.sets.end());
    const std::string sizes = std::to_string(*least) + (*least == *most ? "" : " to " + std::to_string(*most));
    return study.sets.size() == 1 ? "one set of " + sizes : std::to_string(study.sets.size()) + " sets of " + sizes;
}

void add_facts(JsonObject& json, std::size_t hits, std::size_t trials) {
    const Interval interval = wilson(hits, trials);
    json.add("matched", static_cast<double>(hits) / static_cast<double>(trials));
    json.add("low", interval.low);
    json.add("high", interval.high);
}

std::string recipe_json(const MatchingStudy& study, const MatchedRecipe& recipe) {
    JsonObject json;
    json.add("recipe", recipe.name);
    add_facts(json, recipe.hits(), study.trials());
    const Means means = means_of(recipe);
    json.add("ink", means.ink);
    json.add("stroke_length_mm", means.length);
    if (means.contours.truth > 0) json.add("recall", means.contours.recall());
    json.add("empty", static_cast<double>(recipe.empty()));
    if (const std::string paper = paper_rate(recipe.name); !paper.empty()) json.add("paper", paper);
    std::vector<std::string> list;
    for (std::size_t i = 0; i < recipe.sheets.size(); ++i) {
        JsonObject picture;
        picture.add("picture", study.pictures[i]);
        add_facts(picture, recipe.sheets[i].hits, static_cast<std::size_t>(study.readers));
        picture.add("ink", recipe.sheets[i].ink);
        picture.add("stroke_length_mm", recipe.sheets[i].length);
        if (recipe.sheets[i].contours.truth > 0) picture.add("recall", recipe.sheets[i].contours.recall());
        list.push_back(picture.text());
    }
    json.add_raw("pictures", json_array(list));
    list.clear();
    for (const Mistake& mistake : recipe.mistakes) {
        JsonObject one;
        one.add("picture", study.pictures[mistake.picture]);
        one.add("taken_for", study.pictures[mistake.taken_for]);
        one.add("times", static_cast<double>(mistake.times));
        list.push_back(one.text());
    }
    json.add_raw("mistakes", json_array(list));
    list.clear();
    for (const double rate : recipe.random) list.push_back(to_text(rate));
    json.add_raw("matched_by_random_readers", json_array(list));
    list.clear();
    for (const double rate : recipe.changed) list.push_back(to_text(rate));
    json.add_raw("matched_by_changed_readers", json_array(list));
    return json.text();
}

std::string reader_json(const FingertipReader& reader) {
    JsonObject json;
    for (const ReaderRange& range : reader_ranges()) json.add(range.name, range.get(reader));
    return json.text();
}

}  // namespace

std::string matching_text(const MatchingStudy& study) {
    std::vector<Row> rows{{"recipe", "matched", "95 %", "random readers", "ink", "line mm", "recall", "empty", "pilot study"}};
    for (const MatchedRecipe& recipe : study.recipes) {
        const Means means = means_of(recipe);
        const Interval interval = wilson(recipe.hits(), study.trials());
        rows.push_back({recipe.name, fixed(rate_of(study, recipe), 3), fixed(interval.low, 2) + "-" + fixed(interval.high, 2),
                        fixed(middle_of_unsorted(recipe.random), 2), fixed(100 * means.ink, 1) + " %",
                        means.length > 0 ? fixed(means.length, 0) : "",
                        means.contours.truth > 0 ? fixed(means.contours.recall(), 2) : "", std::to_string(recipe.empty()),
                        paper_rate(recipe.name)});
    }
    std::string text = aligned(std::move(rows));
    text +=
        "A simulation, not a study with people: " + std::to_string(study.readers) + " simulated readers felt each of " +
        std::to_string(study.pictures.size()) + " sheets and looked for it among all of its kind by touch (" + sets_text(study) +
        "; by chance " + fixed(study.chance(), 3) +
        "). The reader has not been checked on people. A rate alone rewards sheets with little on them: read it beside recall.\n";
    text += "The usual reader: " + reader_text(study.reader) + ".\n";
    text += order_lines(study) + changes_text(study);
    for (const MatchedRecipe& recipe : study.recipes)
        text += "Hardest of " + recipe.name + ": " + hardest(study, recipe) + mistakes_text(study, recipe) + ".\n";
    return text;
}

std::string matching_csv(const MatchingStudy& study) {
    std::vector<Row> rows{{"recipe", "picture", "trials", "hits", "matched", "low", "high", "ink", "stroke_length_mm", "recall"}};
    const auto add = [&](const std::string& recipe, const std::string& picture, std::size_t hits, std::size_t trials,
                         const Means& means) {
        const Interval interval = wilson(hits, trials);
        rows.push_back({recipe, picture, std::to_string(trials), std::to_string(hits),
                        fixed(static_cast<double>(hits) / static_cast<double>(trials), 3), fixed(interval.low, 3),
                        fixed(interval.high, 3), fixed(means.ink, 4), fixed(means.length, 1),
                        means.contours.truth > 0 ? fixed(means.contours.recall(), 3) : ""});
    };
    for (const MatchedRecipe& recipe : study.recipes) {
        add(recipe.name, "", recipe.hits(), study.trials(), means_of(recipe));
        for (std::size_t i = 0; i < recipe.sheets.size(); ++i) {
            const SheetFacts& sheet = recipe.sheets[i];
            add(recipe.name, study.pictures[i], sheet.hits, static_cast<std::size_t>(study.readers),
                {sheet.ink, sheet.length, sheet.contours});
        }
    }
    return comma_separated(rows);
}

std::string matching_json(const MatchingStudy& study) {
    std::string text;
    for (const MatchedRecipe& recipe : study.recipes) text += recipe_json(study, recipe) + "\n";
    JsonObject whole;
    whole.add("study", "matching by simulated readers");
    whole.add("pictures", static_cast<double>(study.pictures.size()));
    std::vector<std::string> list;
    for (const std::size_t size : study.sets) list.push_back(std::to_string(size));
    whole.add_raw("sets", json_array(list));
    whole.add("readers", static_cast<double>(study.readers));
    whole.add("chance", study.chance());
    whole.add_raw("reader", reader_json(study.reader));
    list.clear();
    for (const FingertipReader& reader : study.random_readers) list.push_back(reader_json(reader));
    whole.add_raw("random_readers", json_array(list));
    list.clear();
    for (const ChangedReader& changed : study.changed_readers) list.push_back(json_text(changed.change));
    whole.add_raw("changed_readers", json_array(list));
    if (!papers_five(study).empty()) {
        whole.add_raw("papers_order", exceptions_to_the_order(study).empty() ? "true" : "false");
        whole.add("papers_order_under_random_readers", static_cast<double>(readers_of_the_order(study).size()));
    }
    whole.add_raw("problems", json_text_array(study.problems));
    return text + whole.text() + "\n";
}

}  // namespace tactics
