// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/check_report.h"

#include <algorithm>

#include "cli/report/say.h"
#include "cli/report/user_language.h"
#include "tactics/text/json.h"
#include "tactics/units.h"

namespace tactics {

namespace {

Phrase with_unit(const Rule& rule, double value) {
    if (rule.limit.unit == "mm") return phrase("{0} mm", shown(value));
    if (rule.limit.unit == "percent") return phrase("{0} percent", shown(value));
    return rule.limit.unit.empty() ? shown(value) : phrase("{0} square cm", shown(value));
}

std::string rule_json(const Verdict& verdict) {
    const Rule& rule = *verdict.demand.rule;
    std::vector<std::string> findings;
    for (const Finding& finding : verdict.findings.places) {
        JsonObject json;
        json.add("message", finding.message.english());
        json.add("measured", finding.measured);
        if (!finding.whole_page) {
            json.add("x_mm", finding.at.x);
            json.add("y_mm", finding.at.y);
        }
        if (finding.other) {
            json.add("other_x_mm", finding.other->x);
            json.add("other_y_mm", finding.other->y);
        }
        findings.push_back(json.text());
    }
    JsonObject json;
    json.add("rule", rule.name);
    json.add_raw("hard", rule.hard ? "true" : "false");
    json.add("confidence", name_of(rule.confidence));
    json.add(rule.limit.name, verdict.demand.limit);
    json.add("unit", rule.limit.unit);
    json.add_raw("complete", verdict.findings.complete ? "true" : "false");
    json.add_raw("findings", json_array(findings));
    return json.text();
}

}  // namespace

Count count_of(const Checked& checked) {
    Count count;
    for (const Verdict& verdict : checked.verdicts) {
        (verdict.demand.rule->hard ? count.hard : count.others) += verdict.findings.places.size();
        count.complete = count.complete && verdict.findings.complete;
    }
    return count;
}

Phrase place_of(const Finding& finding) {
    if (finding.whole_page) return phrase("whole page");
    return phrase("{0} mm right, {1} mm down", numeral(std::round(finding.at.x * 10) / 10),
                  numeral(std::round(finding.at.y * 10) / 10));
}

Phrase what_is_wrong(const Verdict& verdict, const Finding& finding) {
    const Rule& rule = *verdict.demand.rule;
    const Phrase limit = with_unit(rule, verdict.demand.limit);
    return rule.limit.name == "least" ? phrase("{0}, least is {1}; {2}", finding.message, limit, phrase(rule.mend))
                                      : phrase("{0}, most is {1}; {2}", finding.message, limit, phrase(rule.mend));
}

std::string text_report(const Checked& checked, std::size_t most, bool marks) {
    const Phrase file = checked.file == "-" ? phrase("standard input") : Phrase(one_line(checked.file));
    std::string text;
    const auto tell = [&](const Phrase& line) { text += phrase("{0}: {1}", file, line).in(user_language()) + "\n"; };
    for (const Phrase& note : checked.found.notes) tell(phrase("note: {0}", note));
    std::size_t mark = 0;
    for (const Verdict& verdict : checked.verdicts) {
        const Rule& rule = *verdict.demand.rule;
        const auto& places = verdict.findings.places;
        const Phrase name = rule.hard ? phrase("{0}, hard", rule.name) : Phrase(rule.name);
        for (std::size_t i = 0; i < std::min(most, places.size()); ++i) {
            const Phrase line = phrase("{0}: {1} ({2})", place_of(places[i]), what_is_wrong(verdict, places[i]), name);
            tell(marks ? phrase("mark {0}: {1}", std::to_string(++mark), line) : line);
        }
        if (places.size() > most)
            tell(phrase("and {0} more ({1}); --most all shows them", std::to_string(places.size() - most), name));
        if (!verdict.findings.complete)
            tell(phrase("there is so much on this page that looking was ended; there may be more ({0})", name));
    }
    const Count count = count_of(checked);
    if (count.hard + count.others > 0)
        tell(phrase("{0}, {1}; see tactics help check",
                    phrases(count.hard, "{0} place breaks a hard rule", "{0} places break hard rules"),
                    phrases(count.others, "{0} place breaks another", "{0} places break others")));
    else
        tell(count.complete ? phrase("no rule is broken") : phrase("no broken rule was found, but not everything was looked at"));
    return text;
}

std::string json_report(const Checked& checked) {
    JsonAnswer json;
    json.add("file", checked.file);
    if (!checked.error.empty()) {
        json.add("error", checked.error);
        return json.text() + "\n";
    }
    const Count count = count_of(checked);
    json.add("medium", checked.medium->name);
    json.add("page_width_mm", checked.found.page.width);
    json.add("page_height_mm", checked.found.page.height);
    json.add("strokes", static_cast<double>(checked.found.page.strokes.size()));
    json.add("areas", static_cast<double>(checked.found.page.areas.size()));
    json.add("braille_lines", static_cast<double>(checked.found.page.braille.size()));
    json.add("hard", static_cast<double>(count.hard));
    json.add("others", static_cast<double>(count.others));
    json.add_raw("notes", json_text_array(checked.found.notes));
    std::vector<std::string> parts;
    for (const Verdict& verdict : checked.verdicts) parts.push_back(rule_json(verdict));
    json.add_raw("rules", json_array(parts));
    return json.text() + "\n";
}

}  // namespace tactics
