// SPDX-License-Identifier: Apache-2.0
// The reports that programs of others read: SARIF and JUnit.
#include "cli/report/say.h"
#include "cli/verbs/check_report.h"
#include "tactics/text/json.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

std::string message_json(std::string_view text) {
    JsonObject json;
    json.add("text", text);
    return json.text();
}

// RFC 3986: what is not unreserved is written as %XX, so that any file name makes an address.
std::string address_of(std::string_view path) {
    constexpr std::string_view kDigits = "0123456789ABCDEF";
    constexpr std::string_view kPlain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~/";
    std::string address;
    for (const char c : path) {
        if (kPlain.find(c) != std::string_view::npos) {
            address += c;
            continue;
        }
        const auto byte = static_cast<unsigned char>(c);
        address += '%';
        address += kDigits[byte >> 4];
        address += kDigits[byte & 15];
    }
    return address;
}

std::string rule_entry(const Rule& rule) {
    JsonObject level;
    level.add("level", rule.hard ? "error" : "warning");
    JsonObject json;
    json.add("id", rule.name);
    json.add_raw("shortDescription", message_json(rule.summary));
    json.add_raw("fullDescription", message_json("Source: " + std::string(rule.source) +
                                                 ". Confidence: " + std::string(name_of(rule.confidence)) + "."));
    json.add_raw("help", message_json(rule.mend.text));
    json.add_raw("defaultConfiguration", level.text());
    return json.text();
}

std::string result_entry(const Checked& checked, const Verdict& verdict, const Finding& finding) {
    JsonObject artifact;
    artifact.add("uri", address_of(checked.file));
    JsonObject physical;
    physical.add_raw("artifactLocation", artifact.text());
    JsonObject place;
    place.add("name", place_of(finding).english());
    JsonObject location;
    location.add_raw("physicalLocation", physical.text());
    location.add_raw("logicalLocations", "[" + place.text() + "]");
    JsonObject measures;
    measures.add("measured", finding.measured);
    measures.add("limit", verdict.demand.limit);
    if (!finding.whole_page) {
        measures.add("x_mm", finding.at.x);
        measures.add("y_mm", finding.at.y);
    }
    JsonObject json;
    json.add("ruleId", verdict.demand.rule->name);
    json.add("level", verdict.demand.rule->hard ? "error" : "warning");
    json.add_raw("message", message_json(place_of(finding).english() + ": " + what_is_wrong(verdict, finding).english()));
    json.add_raw("locations", "[" + location.text() + "]");
    json.add_raw("properties", measures.text());
    return json.text();
}

// XML 1.0 takes no control characters but three, and no bytes that are not UTF-8.
std::string xml_text(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        std::string_view rest = text;
        const bool letter = take_letter(rest) != kNoLetter;
        const std::string_view one = text.substr(0, text.size() - rest.size());
        const char c = one[0];
        if (!letter || (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t'))
            out += '?';
        else if (c == '<')
            out += "&lt;";
        else if (c == '>')
            out += "&gt;";
        else if (c == '&')
            out += "&amp;";
        else if (c == '"')
            out += "&quot;";
        else
            out += one;
        text = rest;
    }
    return out;
}

std::string suite_of(const Checked& checked) {
    std::string cases;
    std::size_t failures = 0;
    const std::string file = xml_text(checked.file);
    const auto open = [&](std::string_view name) {
        return "    <testcase classname=\"" + file + "\" name=\"" + std::string(name) + "\">\n";
    };
    for (const Verdict& verdict : checked.verdicts) {
        std::string places;
        for (const Finding& finding : verdict.findings.places)
            places += place_of(finding).english() + ": " + what_is_wrong(verdict, finding).english() + "\n";
        if (!verdict.findings.complete) places += "looking was ended before everything was seen\n";
        const bool failed = verdict.demand.rule->hard && !verdict.findings.places.empty();
        failures += failed ? 1 : 0;
        cases += open(verdict.demand.rule->name);
        if (failed)
            cases += "      <failure message=\"" + std::to_string(verdict.findings.places.size()) + " places\">" +
                     xml_text(places) + "</failure>\n";
        else if (!places.empty())
            cases += "      <system-out>" + xml_text(places) + "</system-out>\n";
        cases += "    </testcase>\n";
    }
    const bool error = !checked.error.empty();
    if (error) cases += open("read") + "      <error message=\"" + xml_text(checked.error) + "\"/>\n    </testcase>\n";
    return "  <testsuite name=\"" + file + "\" tests=\"" + std::to_string(checked.verdicts.size() + (error ? 1 : 0)) +
           "\" failures=\"" + std::to_string(failures) + "\" errors=\"" + (error ? "1" : "0") + "\">\n" + cases +
           "  </testsuite>\n";
}

}  // namespace

std::string sarif_report(const std::vector<Checked>& all) {
    std::vector<std::string> entries, results, failures;
    for (const Rule* rule : rules()) entries.push_back(rule_entry(*rule));
    for (const Checked& checked : all) {
        for (const Verdict& verdict : checked.verdicts)
            for (const Finding& finding : verdict.findings.places) results.push_back(result_entry(checked, verdict, finding));
        if (checked.error.empty()) continue;
        JsonObject failure;
        failure.add("level", "error");
        failure.add_raw("message", message_json(checked.error));
        failures.push_back(failure.text());
    }
    JsonObject driver;
    driver.add("name", "tactics");
    driver.add("version", TACTICS_VERSION);
    driver.add_raw("rules", json_array(entries));
    JsonObject tool;
    tool.add_raw("driver", driver.text());
    JsonObject invocation;
    invocation.add_raw("executionSuccessful", failures.empty() ? "true" : "false");
    invocation.add_raw("toolExecutionNotifications", json_array(failures));
    JsonObject run;
    run.add_raw("tool", tool.text());
    run.add_raw("invocations", "[" + invocation.text() + "]");
    run.add_raw("results", json_array(results));
    JsonObject json;
    json.add("$schema", "https://json.schemastore.org/sarif-2.1.0.json");
    json.add("version", "2.1.0");
    json.add_raw("runs", "[" + run.text() + "]");
    return json.text() + "\n";
}

std::string junit_report(const std::vector<Checked>& all) {
    std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"tactics check\">\n";
    for (const Checked& checked : all) text += suite_of(checked);
    return text + "</testsuites>\n";
}

}  // namespace tactics
