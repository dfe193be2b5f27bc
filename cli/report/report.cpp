// SPDX-License-Identifier: Apache-2.0
#include "cli/report/report.h"

#include <algorithm>
#include <cmath>

#include "tactics/job/mending_json.h"
#include "tactics/text/json.h"
#include "tactics/text/rounded.h"
#include "tactics/units.h"

namespace tactics {

namespace {

Phrase content(const Layout& layout) {
    if (layout.empty) return phrase("nothing to feel");
    std::vector<Phrase> parts;
    if (layout.pages > 1) parts.push_back(phrases(layout.pages, "{0} page", "{0} pages"));
    if (layout.strokes > 0)
        parts.push_back(phrases(layout.strokes, "{0} line of {1} mm together", "{0} lines of {1} mm together",
                                rounded(layout.stroke_length, 1)));
    if (layout.text_lines > 0) parts.push_back(phrases(layout.text_lines, "{0} line of braille", "{0} lines of braille"));
    if (layout.areas > 0) parts.push_back(phrases(layout.areas, "{0} area", "{0} areas"));
    if (layout.textured > 0) parts.push_back(phrases(layout.textured, "{0} textured area", "{0} textured areas"));
    if (layout.has_picture) parts.push_back(phrase("a picture of dots"));
    return row_of(parts);
}

// The outputs of those layouts.
template <typename Which>
std::vector<Phrase> paths_of(const Outcome& outcome, const Which& which) {
    std::vector<Phrase> paths;
    for (const Made& made : outcome.made)
        if (which(made.layout)) paths.push_back(made.output.path == "-" ? phrase("standard output") : Phrase(made.output.path));
    return paths;
}

std::string broken_json(const std::vector<BrokenRule>& rules) {
    std::vector<std::string> parts;
    for (const BrokenRule& rule : rules) {
        JsonObject json;
        json.add("rule", rule.name);
        json.add_raw("hard", rule.hard ? "true" : "false");
        json.add("places", static_cast<double>(rule.places));
        json.add_raw("complete", rule.complete ? "true" : "false");
        parts.push_back(json.text());
    }
    return json_array(parts);
}

std::string detail_json(const DetailChoice& choice) {
    std::vector<std::string> tried;
    for (const TriedDetail& one : choice.tried) {
        JsonObject json;
        json.add("times", one.times);
        json.add("line_mm", one.line);
        json.add("agreed", one.agreed);
        json.add("loss", one.loss);
        json.add("broken", static_cast<double>(one.broken));
        tried.push_back(json.text());
    }
    JsonObject json;
    json.add("times", choice.chosen().times);
    json.add("loss", choice.chosen().loss);
    json.add_raw("tried", json_array(tried));
    return json.text();
}

std::string made_json(const Outcome& outcome, const Made& made) {
    const Layout& layout = outcome.layouts[made.layout];
    JsonObject json;
    json.add("path", made.output.path);
    json.add("format", made.output.format->name);
    if (!made.output.bound) json.add("bytes", static_cast<double>(made.bytes));
    json.add("page", static_cast<double>(made.page));
    json.add("pages", static_cast<double>(made.pages));
    json.add("medium", layout.sheet.medium->name);
    json.add("paper", layout.sheet.paper.name);
    json.add("page_width_mm", layout.place.page_width);
    json.add("page_height_mm", layout.place.page_height);
    json.add("drawing_left_mm", layout.place.drawing.left);
    json.add("drawing_top_mm", layout.place.drawing.top);
    json.add("drawing_width_mm", layout.place.drawing.width);
    json.add("drawing_height_mm", layout.place.drawing.height);
    if (const Rect& part = outcome.part; part.width < 1 || part.height < 1)
        json.add_raw("part_percent",
                     json_array({to_text(100 * part.left), to_text(100 * part.top), to_text(100 * (part.left + part.width)),
                                 to_text(100 * (part.top + part.height))}));
    json.add("strokes", static_cast<double>(layout.strokes));
    json.add("stroke_length_mm", layout.stroke_length);
    json.add("areas", static_cast<double>(layout.areas));
    json.add("textured_areas", static_cast<double>(layout.textured));
    json.add_raw("picture", layout.has_picture ? "true" : "false");
    if (!layout.names.empty()) json.add_raw("names", json_text_array(layout.names));
    if (layout.text_lines > 0) json.add("text_lines", static_cast<double>(layout.text_lines));
    json.add_raw("empty", layout.empty ? "true" : "false");
    if (made.heights) json.add_raw("heights", heights_json(*made.heights));
    if (layout.detail) json.add_raw("detail", detail_json(*layout.detail));
    add_mending(json, layout.mended, layout.place.drawing);
    if (!layout.broken.empty()) json.add_raw("broken_rules", broken_json(layout.broken));
    return json.text();
}

std::string words_json(const ToldWords& words) {
    JsonObject json;
    json.add("text", words.text);
    json.add("sureness", words.sureness);
    json.add_raw("set", words.set ? "true" : "false");
    if (words.out) json.add_raw("left_out", "true");
    json.add("x_percent", words.x);
    json.add("y_percent", words.y);
    return json.text();
}

// The note on an empty page; empty if every page has something to feel.
Phrase nothing_words(const Outcome& outcome) {
    const auto paths = paths_of(outcome, [&](std::size_t layout) { return outcome.layouts[layout].empty; });
    if (paths.empty()) return {};
    if (outcome.recipe.empty())  // of lines that were there already
        return phrase("nothing was drawn: it has no lines that could be felt on {0}; look whether they are white or hidden",
                      row_of(paths));
    return outcome.keeps_some
               ? phrase("nothing was drawn: recipe {0} leaves nothing to feel on {1}; try --detail contours or another --recipe",
                        outcome.recipe, row_of(paths))
               : phrase("nothing was drawn: recipe {0} leaves nothing to feel on {1}; try another --recipe", outcome.recipe,
                        row_of(paths));
}

void add_mending(Notes& lines, const Outcome& outcome) {
    for (const Layout& layout : outcome.layouts) {
        Phrase notes;
        for (const Phrase& note : layout.mended.notes) notes = notes.empty() ? note : phrase("{0} {1}", std::move(notes), note);
        if (!notes.empty()) lines.push_back(phrase("changed to be felt: {0} --as-drawn leaves it as it was", std::move(notes)));
        if (!layout.mended.advice.empty()) lines.push_back(to_act_on(layout.mended.advice));
    }
    // Once: of another size the numbers differ a little, and the picture is the same.
    const auto doubtful = std::find_if(outcome.layouts.begin(), outcome.layouts.end(),
                                       [](const Layout& layout) { return !layout.mended.doubt.empty(); });
    if (doubtful != outcome.layouts.end()) lines.push_back(to_act_on(doubtful->mended.doubt));
}

void add_broken(Notes& lines, const Outcome& outcome) {
    for (std::size_t i = 0; i < outcome.layouts.size(); ++i) {
        std::vector<Phrase> hard, soft, unseen;
        for (const BrokenRule& rule : outcome.layouts[i].broken) {
            if (rule.places > 0)
                (rule.hard ? hard : soft).push_back(phrases(rule.places, "{1} at {0} place", "{1} at {0} places", rule.name));
            if (!rule.complete) unseen.emplace_back(rule.name);
        }
        const auto pages = [&] { return row_of(paths_of(outcome, [i](std::size_t layout) { return layout == i; })); };
        if (!hard.empty())
            lines.push_back(
                to_act_on(phrase("hard rules are broken on {0}: {1}; tactics check shows where on the page as SVG or PDF",
                                 pages(), row_of(hard))));
        if (!soft.empty())
            lines.push_back(
                phrase("rules that are not hard are broken on {0}: {1}; tactics check shows where on the page as SVG or PDF",
                       pages(), row_of(soft)));
        if (!unseen.empty())
            lines.push_back(to_act_on(
                phrase("there is so much on {0} that looking was ended; there may be more ({1})", pages(), row_of(unseen))));
    }
}

// Places of one line of a batch, which names no rules.
std::size_t softly_broken(const Outcome& outcome) {
    std::size_t places = 0;
    for (const Layout& layout : outcome.layouts)
        for (const BrokenRule& rule : layout.broken) places += rule.hard ? 0 : rule.places;
    return places;
}

Phrase left_over_words(const Outcome& outcome) {
    const std::vector<Phrase> names(outcome.left_over.begin(), outcome.left_over.end());
    return phrases(names.size(), "{1} is no page of it but named like one; if it is left of an earlier run, delete it",
                   "{1} are no pages of it but named like one; if it is left of an earlier run, delete it", row_of(names));
}

// Without the name of the picture.
Notes further_words(const Outcome& outcome) {
    Notes lines;
    add_mending(lines, outcome);
    if (Phrase nothing = nothing_words(outcome); !nothing.empty()) lines.push_back(to_act_on(std::move(nothing)));
    add_broken(lines, outcome);
    lines.insert(lines.end(), outcome.notes.begin(), outcome.notes.end());
    if (!outcome.left_over.empty()) lines.push_back(to_act_on(left_over_words(outcome)));
    return lines;
}

}  // namespace

std::string heights_json(const KindHeights& heights) {
    static constexpr std::string_view kKinds[kLineKinds] = {"drawn", "inner", "values", "grid", "pattern"};
    std::vector<std::string> losses;
    for (const double loss : heights.losses) losses.push_back(to_text(loss));
    JsonObject json;
    json.add("used", heights.used);
    json.add("most", heights.most());
    json.add("loss", heights.losses.empty() ? 0 : heights.losses[static_cast<std::size_t>(heights.used) - 1]);
    json.add_raw("losses", json_array(losses));
    JsonObject shares;
    for (std::size_t kind = 0; kind < kLineKinds; ++kind)
        if (heights.there[kind]) shares.add(kKinds[kind], heights.share(static_cast<LineKind>(kind)));
    json.add_raw("kinds", shares.text());
    return json.text();
}

Phrase result_line(const Outcome& outcome) {
    const Phrase name = name_of_input(outcome);
    if (outcome.up_to_date) return phrase("{0}: up to date", name);
    Phrase made;
    for (std::size_t i = 0; i < outcome.layouts.size(); ++i) {
        Phrase one = phrase("{0}: {1}", row_of(paths_of(outcome, [i](std::size_t layout) { return layout == i; })),
                            content(outcome.layouts[i]));
        made = i == 0 ? std::move(one) : phrase("{0}; {1}", std::move(made), std::move(one));
    }
    Phrase line =
        phrase("{0}: {1}; {2} s", name, std::move(made), numeral(std::round(std::max(outcome.seconds, 0.01) * 100) / 100));
    if (outcome.made_anew.empty()) return line;
    return phrase("{0}; made anew: {1}", std::move(line), row_of(outcome.made_anew));
}

Phrase result_with_warnings(const Outcome& outcome) {
    Phrase line = result_line(outcome);
    if (const std::size_t places = softly_broken(outcome); places > 0)
        line = phrase("{0}; {1}", std::move(line),
                      phrases(places, "{0} place breaks a rule that is not hard", "{0} places break rules that are not hard"));
    for (Note& note : further_words(outcome))
        if (note.asks()) line = phrase("{0}; {1}", std::move(line), std::move(note.words));
    return line;
}

std::vector<Phrase> choice_lines(const Outcome& outcome) {
    std::vector<Phrase> lines;
    const Phrase start = name_of_input(outcome);
    if (!outcome.reason.empty())
        lines.push_back(phrase("{0}: recipe {1} ({2}); change with --recipe", start, outcome.recipe, outcome.reason));
    for (const ChosenSetting& choice : outcome.chosen) {
        const std::string name = choice.filter + "." + choice.setting.substr(0, choice.setting.find('='));
        lines.push_back(choice.can_be_changed() ? phrase("{0}: {1}; change with --set {2}=NUMBER", start, choice.words(), name)
                                                : phrase("{0}: {1}", start, phrase("{0}: {1}", choice.setting, choice.why)));
    }
    return lines;
}

Notes further_lines(const Outcome& outcome) {
    Notes lines = further_words(outcome);
    for (Note& line : lines) line.words = phrase("{0}: {1}", name_of_input(outcome), std::move(line.words));
    return lines;
}

bool needs_a_look(const Outcome& outcome) {
    return std::any_of(outcome.layouts.begin(), outcome.layouts.end(),
                       [](const Layout& layout) { return !layout.mended.advice.empty() || !layout.mended.doubt.empty(); });
}

std::string result_json(const Outcome& outcome) {
    JsonAnswer json;
    json.add("input", outcome.input);
    if (outcome.pdf_page > 0) json.add("pdf_page", outcome.pdf_page);
    if (!outcome.error.empty()) {
        json.add("error", outcome.error.english());
        json.add("seconds", outcome.seconds);
        return json.text();
    }
    if (outcome.up_to_date) {
        json.add_raw("up_to_date", "true");
        return json.text();
    }
    json.add("format", outcome.picture.format);
    json.add("width", outcome.picture.width);
    json.add("height", outcome.picture.height);
    json.add("recipe", outcome.recipe);
    if (!outcome.reason.empty()) json.add("reason", outcome.reason.english());
    std::vector<std::string> parts;
    for (const auto& step : outcome.steps) parts.push_back(json_text(step));
    json.add_raw("steps", json_array(parts));
    if (!outcome.chosen.empty()) {
        parts.clear();
        for (const auto& choice : outcome.chosen) parts.push_back(json_text(choice.words().english()));
        json.add_raw("chosen", json_array(parts));
    }
    parts.clear();
    for (const Made& made : outcome.made) parts.push_back(made_json(outcome, made));
    json.add_raw("outputs", json_array(parts));
    if (!outcome.words.empty()) {
        parts.clear();
        for (const ToldWords& words : outcome.words) parts.push_back(words_json(words));
        json.add_raw("words", json_array(parts));
    }
    if (!outcome.model_json.empty()) json.add_raw("model", outcome.model_json);
    if (!outcome.made_anew.empty()) json.add_raw("made_anew", json_text_array(outcome.made_anew));
    if (!outcome.chart_json.empty()) json.add_raw("chart", outcome.chart_json);
    if (!outcome.notes.empty()) json.add_raw("notes", json_text_array(texts_of(outcome.notes)));
    Notes warnings = further_words(outcome);
    std::erase_if(warnings, [](const Note& note) { return !note.asks(); });
    if (!warnings.empty()) json.add_raw("warnings", json_text_array(texts_of(warnings)));
    json.add("seconds", outcome.seconds);
    return json.text();
}

Phrase progress_line(std::size_t done, std::size_t all, double seconds) {
    Phrase line = phrase("{0} of {1} done", std::to_string(done), std::to_string(all));
    if (done == 0 || done >= all) return line;
    const double left = seconds / static_cast<double>(done) * static_cast<double>(all - done);
    if (left < 90) return phrase("{0}, about {1} s left", std::move(line), rounded(std::max(left, 1.0), left < 10 ? 1 : 5));
    return phrase("{0}, about {1} minutes left", std::move(line), rounded(left / 60, 1));
}

}  // namespace tactics
