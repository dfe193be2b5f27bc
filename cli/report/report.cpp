// SPDX-License-Identifier: Apache-2.0
#include "cli/report/report.h"

#include <algorithm>

#include "tactics/job/mending_json.h"
#include "tactics/text/json.h"
#include "tactics/text/rounded.h"
#include "tactics/units.h"

namespace tactics {

namespace {

std::string counted(std::size_t count, std::string_view thing) {
    return std::to_string(count) + " " + std::string(thing) + (count == 1 ? "" : "s");
}

std::string content(const Layout& layout) {
    std::string text;
    const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
    if (layout.pages > 1) add(counted(layout.pages, "page"));
    if (layout.strokes > 0) add(counted(layout.strokes, "line") + " of " + rounded(layout.stroke_length, 1) + " mm together");
    if (layout.text_lines > 0) add(counted(layout.text_lines, "line") + " of braille");
    if (layout.areas > 0) add(counted(layout.areas, "area"));
    if (layout.textured > 0) add(counted(layout.textured, "textured area"));
    if (layout.has_picture) add("a picture of dots");
    return layout.empty ? "nothing to feel" : text;
}

// The outputs of those layouts.
template <typename Which>
std::string paths_of(const Outcome& outcome, const Which& which) {
    std::string paths;
    for (const Made& made : outcome.made)
        if (which(made.layout))
            paths += (paths.empty() ? "" : ", ") + (made.output.path == "-" ? "standard output" : made.output.path);
    return paths;
}

std::string broken_json(const std::vector<BrokenRule>& rules) {
    std::vector<std::string> parts;
    for (const BrokenRule& rule : rules) {
        JsonObject json;
        json.add("rule", rule.name);
        json.add("places", static_cast<double>(rule.places));
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
    json.add("strokes", static_cast<double>(layout.strokes));
    json.add("stroke_length_mm", layout.stroke_length);
    json.add("areas", static_cast<double>(layout.areas));
    json.add("textured_areas", static_cast<double>(layout.textured));
    json.add_raw("picture", layout.has_picture ? "true" : "false");
    if (!layout.names.empty()) json.add_raw("names", json_text_array(layout.names));
    if (layout.text_lines > 0) json.add("text_lines", static_cast<double>(layout.text_lines));
    json.add_raw("empty", layout.empty ? "true" : "false");
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
    json.add("x_percent", words.x);
    json.add("y_percent", words.y);
    return json.text();
}

// The note on an empty page; empty if every page has something to feel.
std::string nothing_words(const Outcome& outcome) {
    const std::string paths = paths_of(outcome, [&](std::size_t layout) { return outcome.layouts[layout].empty; });
    if (paths.empty()) return "";
    if (outcome.recipe.empty())  // of lines that were there already
        return "nothing was drawn: it has no lines that could be felt on " + paths + "; look whether they are white or hidden";
    return "nothing was drawn: recipe " + outcome.recipe + " leaves nothing to feel on " + paths + "; try " +
           (outcome.keeps_some ? "--detail contours or " : "") + "another --recipe";
}

void add_mending(Notes& lines, const Outcome& outcome) {
    for (const Layout& layout : outcome.layouts) {
        std::string notes;
        for (const std::string& note : layout.mended.notes) notes += " " + note;
        if (!notes.empty()) lines.push_back("changed to be felt:" + notes + " --as-drawn leaves it as it was");
        if (!layout.mended.advice.empty()) lines.push_back(to_act_on(layout.mended.advice));
    }
    // Once: of another size the numbers differ a little, and the picture is the same.
    const auto doubtful = std::find_if(outcome.layouts.begin(), outcome.layouts.end(),
                                       [](const Layout& layout) { return !layout.mended.doubt.empty(); });
    if (doubtful != outcome.layouts.end()) lines.push_back(to_act_on(doubtful->mended.doubt));
}

void add_broken(Notes& lines, const Outcome& outcome) {
    for (std::size_t i = 0; i < outcome.layouts.size(); ++i) {
        std::string rules;
        for (const BrokenRule& rule : outcome.layouts[i].broken)
            rules += (rules.empty() ? "" : ", ") + std::string(rule.name) + " at " + counted(rule.places, "place");
        if (!rules.empty())
            lines.push_back(to_act_on("hard rules are broken on " +
                                      paths_of(outcome, [i](std::size_t layout) { return layout == i; }) + ": " + rules +
                                      "; tactics check shows where on the page as SVG or PDF"));
    }
}

std::string left_over_words(const Outcome& outcome) {
    std::string names;
    for (const std::string& name : outcome.left_over) names += (names.empty() ? "" : ", ") + name;
    return names + (outcome.left_over.size() == 1 ? " is no page of it" : " are no pages of it") +
           " but named like one; if it is left of an earlier run, delete it";
}

// Without the name of the picture.
Notes further_words(const Outcome& outcome) {
    Notes lines;
    add_mending(lines, outcome);
    if (std::string nothing = nothing_words(outcome); !nothing.empty()) lines.push_back(to_act_on(std::move(nothing)));
    add_broken(lines, outcome);
    lines.insert(lines.end(), outcome.notes.begin(), outcome.notes.end());
    if (!outcome.left_over.empty()) lines.push_back(to_act_on(left_over_words(outcome)));
    return lines;
}

}  // namespace

std::string result_line(const Outcome& outcome) {
    std::string line = name_of_input(outcome) + ": ";
    if (outcome.up_to_date) return line + "up to date";
    for (std::size_t i = 0; i < outcome.layouts.size(); ++i) {
        if (i > 0) line += "; ";
        line += paths_of(outcome, [i](std::size_t layout) { return layout == i; }) + ": " + content(outcome.layouts[i]);
    }
    line += "; " + rounded(std::max(outcome.seconds, 0.01), 0.01) + " s";
    for (std::size_t i = 0; i < outcome.made_anew.size(); ++i) line += (i == 0 ? "; made anew: " : ", ") + outcome.made_anew[i];
    return line;
}

std::vector<std::string> choice_lines(const Outcome& outcome) {
    std::vector<std::string> lines;
    const std::string start = name_of_input(outcome) + ": ";
    if (!outcome.reason.empty())
        lines.push_back(start + "recipe " + outcome.recipe + " (" + outcome.reason + "); change with --recipe");
    for (const std::string& choice : outcome.chosen) {
        // "outlines subject: found, ..." reports a result and is no setting.
        if (choice.find(':') < choice.find('=')) {
            lines.push_back(start + choice.substr(choice.find(' ') + 1));
            continue;
        }
        std::string setting = choice.substr(0, choice.find('='));
        std::replace(setting.begin(), setting.end(), ' ', '.');
        lines.push_back(start + choice + "; change with --set " + setting + "=NUMBER");
    }
    return lines;
}

Notes further_lines(const Outcome& outcome) {
    Notes lines = further_words(outcome);
    for (Note& line : lines) line.text = name_of_input(outcome) + ": " + line.text;
    return lines;
}

bool needs_a_look(const Outcome& outcome) {
    return std::any_of(outcome.layouts.begin(), outcome.layouts.end(),
                       [](const Layout& layout) { return !layout.mended.advice.empty() || !layout.mended.doubt.empty(); });
}

bool breaks_a_rule(const Outcome& outcome) {
    return std::any_of(outcome.layouts.begin(), outcome.layouts.end(),
                       [](const Layout& layout) { return !layout.broken.empty(); });
}

std::string result_json(const Outcome& outcome) {
    JsonAnswer json;
    json.add("input", outcome.input);
    if (outcome.pdf_page > 0) json.add("pdf_page", outcome.pdf_page);
    if (!outcome.error.empty()) {
        json.add("error", outcome.error);
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
    if (!outcome.reason.empty()) json.add("reason", outcome.reason);
    std::vector<std::string> parts;
    for (const auto& step : outcome.steps) parts.push_back(json_text(step));
    json.add_raw("steps", json_array(parts));
    if (!outcome.chosen.empty()) {
        parts.clear();
        for (const auto& choice : outcome.chosen) parts.push_back(json_text(choice));
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

std::string progress_line(std::size_t done, std::size_t all, double seconds) {
    std::string line = std::to_string(done) + " of " + std::to_string(all) + " done";
    if (done == 0 || done >= all) return line;
    const double left = seconds / static_cast<double>(done) * static_cast<double>(all - done);
    if (left < 90) return line + ", about " + rounded(std::max(left, 1.0), left < 10 ? 1 : 5) + " s left";
    return line + ", about " + rounded(left / 60, 1) + " minutes left";
}

}  // namespace tactics
