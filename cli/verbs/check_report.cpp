// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/check_report.h"

#include <algorithm>

#include "cli/report/say.h"
#include "tactics/text/json.h"
#include "tactics/units.h"

namespace tactics {

namespace {

std::string counted(std::size_t count, std::string_view one, std::string_view many) {
    return std::to_string(count) + " " + std::string(count == 1 ? one : many);
}

std::string with_unit(const Rule& rule, double value) {
    return shown(value) + (rule.limit.unit.empty() ? "" : " " + std::string(rule.limit.unit));
}

std::string rule_json(const Verdict& verdict) {
    const Rule& rule = *verdict.demand.rule;
    std::vector<std::string> findings;
    for (const Finding& finding : verdict.findings.places) {
        JsonObject json;
        json.add("message", finding.message);
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

std::string place_of(const Finding& finding) {
    if (finding.whole_page) return "whole page";
    return to_text(std::round(finding.at.x * 10) / 10) + " mm right, " + to_text(std::round(finding.at.y * 10) / 10) + " mm down";
}

std::string what_is_wrong(const Verdict& verdict, const Finding& finding) {
    const Rule& rule = *verdict.demand.rule;
    return finding.message + ", " + std::string(rule.limit.name) + " is " + with_unit(rule, verdict.demand.limit) + "; " +
           std::string(rule.mend);
}

std::string text_report(const Checked& checked, std::size_t most, bool marks) {
    const std::string file = one_line(checked.file == "-" ? "standard input" : checked.file) + ": ";
    std::string text;
    for (const std::string& note : checked.found.notes) text += file + "note: " + note + "\n";
    std::size_t mark = 0;
    for (const Verdict& verdict : checked.verdicts) {
        const Rule& rule = *verdict.demand.rule;
        const auto& places = verdict.findings.places;
        const std::string name = " (" + std::string(rule.name) + (rule.hard ? ", hard)" : ")");
        for (std::size_t i = 0; i < std::min(most, places.size()); ++i)
            text += file + (marks ? "mark " + std::to_string(++mark) + ": " : "") + place_of(places[i]) + ": " +
                    what_is_wrong(verdict, places[i]) + name + "\n";
        if (places.size() > most)
            text += file + "and " + std::to_string(places.size() - most) + " more" + name + "; --most all shows them\n";
        if (!verdict.findings.complete)
            text += file + "there is so much on this page that looking was ended; there may be more" + name + "\n";
    }
    const Count count = count_of(checked);
    if (count.hard + count.others > 0)
        return text + file + counted(count.hard, "place breaks a hard rule", "places break hard rules") + ", " +
               counted(count.others, "place breaks another", "places break others") + "; see tactics help check\n";
    return text + file +
           (count.complete ? "no rule is broken\n" : "no broken rule was found, but not everything was looked at\n");
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
