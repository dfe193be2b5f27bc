// SPDX-License-Identifier: Apache-2.0
#include "studies/matching_report.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "studies/told_table.h"
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

// Empty: it holds.
Phrase exceptions_to_the_order(const MatchingStudy& study) {
    const auto five = papers_five(study);
    Phrase text;
    for (const auto& [worse, better] : kOrder) {
        const double low = rate_of(study, *five[worse]), high = rate_of(study, *five[better]);
        if (low < high) continue;
        Phrase one = phrase("{0} {1} is not above {2} {3}", five[better]->name, fixed_numeral(high, 2), five[worse]->name,
                            fixed_numeral(low, 2));
        text = text.empty() ? std::move(one) : phrase("{0}; {1}", std::move(text), std::move(one));
    }
    return text;
}

Phrase with_unit(Phrase value, const ReaderRange& range) {
    return range.unit.text.empty() ? value : phrase("{0} {1}", std::move(value), phrase(range.unit));
}

Phrase range_text(const ReaderRange& range, double least, double most) {
    Phrase value =
        least == most ? fixed_numeral(least, 2) : phrase("{0} to {1}", fixed_numeral(least, 2), fixed_numeral(most, 2));
    return phrase("{0} {1}", phrase(range.name), with_unit(std::move(value), range));
}

Phrase reader_text(const FingertipReader& reader) {
    std::vector<Phrase> parts;
    for (const ReaderRange& range : reader_ranges())
        parts.push_back(phrase("{0} {1}", phrase(range.name), with_unit(numeral(range.get(reader)), range)));
    return row_of(parts);
}

std::vector<Phrase> order_lines(const MatchingStudy& study) {
    if (papers_five(study).empty()) return {};
    const Phrase exceptions = exceptions_to_the_order(study);
    const Phrase order = phrase("none, then kmeans and sobel, then kmeans-sobel, then sobel-kmeans");
    std::vector<Phrase> lines;
    lines.push_back(exceptions.empty()
                        ? phrase("The paper's order ({0}) comes out with the usual reader.", order)
                        : phrase("The paper's order ({0}) does not come out with the usual reader: {1}.", order, exceptions));
    const auto held = readers_of_the_order(study);
    std::vector<Phrase> drawn, there;
    for (const ReaderRange& range : reader_ranges()) {
        drawn.push_back(range_text(range, range.least, range.most));
        double least = range.most, most = range.least;
        for (const std::size_t i : held) {
            least = std::min(least, range.get(study.random_readers[i]));
            most = std::max(most, range.get(study.random_readers[i]));
        }
        there.push_back(range_text(range, least, most));
    }
    const std::string all = std::to_string(study.random_readers.size()), some = std::to_string(held.size());
    const Phrase share = numeral_of(percent(static_cast<double>(held.size()) / static_cast<double>(study.random_readers.size())));
    lines.push_back(held.empty()
                        ? phrase("Under {0} readers with parameters at random it comes out in {1} ({2}).", all, some, share)
                        : phrase("Under {0} readers with parameters at random it comes out in {1} ({2}): with {3}.", all, some,
                                 share, row_of(there)));
    lines.push_back(phrase("They were drawn from {0}.", row_of(drawn)));
    return lines;
}

// A line for each change, a column for each recipe.
std::string changes_text(const MatchingStudy& study, std::string_view language) {
    std::vector<ToldRow> rows{{phrase("one parameter changed")}};
    for (const MatchedRecipe& recipe : study.recipes) rows[0].push_back(recipe.name);
    for (std::size_t i = 0; i < study.changed_readers.size(); ++i) {
        rows.push_back({study.changed_readers[i].change});
        for (const MatchedRecipe& recipe : study.recipes) rows.back().push_back(fixed(recipe.changed[i], 2));
    }
    for (ToldRow& row : rows) row.emplace_back();  // the last column of a table starts at the left
    return told_table(rows, language);
}

Phrase hardest(const MatchingStudy& study, const MatchedRecipe& recipe) {
    std::vector<std::size_t> order(study.pictures.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return recipe.sheets[a].hits < recipe.sheets[b].hits; });
    std::vector<Phrase> sheets;
    for (std::size_t i = 0; i < std::min<std::size_t>(order.size(), 3); ++i)
        sheets.push_back(phrase("{0} {1}", study.pictures[order[i]],
                                fixed_numeral(static_cast<double>(recipe.sheets[order[i]].hits) / study.readers, 2)));
    return row_of(sheets);
}

Phrase hardest_line(const MatchingStudy& study, const MatchedRecipe& recipe) {
    std::vector<Phrase> mistakes;
    for (std::size_t i = 0; i < std::min<std::size_t>(recipe.mistakes.size(), 3); ++i) {
        const Mistake& mistake = recipe.mistakes[i];
        mistakes.push_back(phrase("{0} for {1} {2} of {3}", study.pictures[mistake.picture], study.pictures[mistake.taken_for],
                                  std::to_string(mistake.times), std::to_string(study.readers)));
    }
    const Phrase sheets = hardest(study, recipe);
    if (mistakes.empty()) return phrase("Hardest of {0}: {1}.", recipe.name, sheets);
    return phrase("Hardest of {0}: {1}; most often taken for another: {2}.", recipe.name, sheets, row_of(mistakes));
}

Phrase sets_text(const MatchingStudy& study) {
    const auto [least, most] = std::minmax_element(study.sets.begin(), study.sets.end());
    const Phrase sizes =
        *least == *most ? Phrase(std::to_string(*least)) : phrase("{0} to {1}", std::to_string(*least), std::to_string(*most));
    return phrases(study.sets.size(), "one set of {1}", "{0} sets of {1}", sizes);
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
    for (const ReaderRange& range : reader_ranges()) json.add(range.name.text, range.get(reader));
    return json.text();
}

}  // namespace

std::string matching_text(const MatchingStudy& study, std::string_view language) {
    std::vector<ToldRow> rows{{phrase("recipe"), phrase("matched"), "95 %", phrase("random readers"), phrase("ink"),
                               phrase("line mm"), phrase("recall"), phrase("empty"), phrase("pilot study")}};
    for (const MatchedRecipe& recipe : study.recipes) {
        const Means means = means_of(recipe);
        const Interval interval = wilson(recipe.hits(), study.trials());
        rows.push_back({recipe.name, fixed(rate_of(study, recipe), 3), fixed(interval.low, 2) + "-" + fixed(interval.high, 2),
                        fixed(middle_of_unsorted(recipe.random), 2), fixed(100 * means.ink, 1) + " %",
                        means.length > 0 ? fixed(means.length, 0) : "",
                        means.contours.truth > 0 ? fixed(means.contours.recall(), 2) : "", std::to_string(recipe.empty()),
                        paper_rate(recipe.name)});
    }
    std::string text = told_table(rows, language);
    const auto add = [&](const Phrase& line) { text += line.in(language) + "\n"; };
    add(phrase(
        "A simulation, not a study with people: {0} simulated readers felt each of {1} sheets and looked for it among all of "
        "its kind by touch ({2}; by chance {3}). The reader has not been checked on people. A rate alone rewards sheets with "
        "little on them: read it beside recall.",
        std::to_string(study.readers), std::to_string(study.pictures.size()), sets_text(study),
        fixed_numeral(study.chance(), 3)));
    add(phrase("The usual reader: {0}.", reader_text(study.reader)));
    for (const Phrase& line : order_lines(study)) add(line);
    text += changes_text(study, language);
    for (const MatchedRecipe& recipe : study.recipes) add(hardest_line(study, recipe));
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
    for (const ChangedReader& changed : study.changed_readers) list.push_back(json_text(changed.change.english()));
    whole.add_raw("changed_readers", json_array(list));
    if (!papers_five(study).empty()) {
        whole.add_raw("papers_order", exceptions_to_the_order(study).empty() ? "true" : "false");
        whole.add("papers_order_under_random_readers", static_cast<double>(readers_of_the_order(study).size()));
    }
    whole.add_raw("problems", json_text_array(study.problems));
    return text + whole.text() + "\n";
}

}  // namespace tactics
