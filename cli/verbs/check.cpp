// SPDX-License-Identifier: Apache-2.0
// `tactics check`: is a page fit to be felt?
#include <algorithm>
#include <cmath>

#include "cli/choice_value.h"
#include "cli/command.h"
#include "cli/flag_values.h"
#include "cli/kept_choices.h"
#include "cli/model_flags.h"
#include "cli/page_flags.h"
#include "cli/report/say.h"
#include "cli/request.h"
#include "cli/table_flags.h"
#include "cli/verbs/check_mark.h"
#include "cli/verbs/check_page.h"
#include "cli/verbs/check_report.h"
#include "tactics/job/workers.h"
#include "tactics/transport/file.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr std::size_t kAll = ~std::size_t{0};

constexpr Flag kCheckFlags[] = {
    {"--medium", "-m", "MEDIUM",
     "what the page is made on; it decides the limits. Default: that of a page that tactics made, else swell", false, "media"},
    {"--paper", "-p", "PAPER", "paper of pictures, and of a drawing whose file gives no size", false, "papers"},
    {"--margin", "", "LENGTH", "margin that must stay free; default: that of a page that tactics made, else the medium's own",
     false, ""},
    {"--rule", "", "RULE", "check this rule only. May be given several times", true, "rules"},
    {"--set", "-s", "RULE.LIMIT=VALUE",
     "change a limit: gap.least=3mm, crossings.most=2; or for pictures a setting of a filter, as for convert. May be given "
     "several "
     "times",
     true, "limits settings"},
    {"--strict", "", "", "exit code 3 if a hard rule is broken", false, ""},
    {"--most", "", "NUMBER|all", "how many places to report for each rule; the rest are counted. Default: 10", false, "all"},
    {"--format", "", "text|json|sarif|junit", "how to report the places; default: text", false, "text json sarif junit"},
    {"--json", "", "", "short for --format json: one JSON object for each file, with all places", false, ""},
    {"--mark", "", "FILE",
     "write the page with the places marked, in the format that FILE ends in: .svg, .png, .pdf; for one file", false, "files"},
    kPdfPageFlag,
    kAllowFlag,
#include "cli/table_flags.inc"
#include "cli/table_flags_of_bars.inc"
    kModelFlag,
    kModelPartFlag,
    kFoldFlag,
    kReaderFlag,
    kRecipeFlag,
    kFilterFlag,
    kDetailFlag,
    kAsDrawnFlag,
};

enum class CheckTold { text, json, sarif, junit };

struct Wanted {
    std::vector<std::string> files;
    PageWish page;
    std::vector<std::pair<const Rule*, double>> limits;
    CheckTold told = CheckTold::text;
    std::size_t most = 10;
    std::string mark;
    const Format* mark_format = nullptr;
    bool strict = false;
};

std::vector<std::string_view> rule_names() {
    std::vector<std::string_view> names;
    for (const Rule* rule : rules()) names.push_back(rule->name);
    return names;
}

const Rule& named_rule(const std::string& name, std::string_view place) {
    if (const Rule* rule = find_rule(name)) return *rule;
    throw Error(
        Fault::usage, place,
        phrase("there is no rule \"{0}\"{1}; see tactics list rules", name.substr(0, 80), did_you_mean(name, rule_names())));
}

// `--set gap.least=3mm`: those of rules are used up, the others are left for the recipe.
std::vector<std::pair<const Rule*, double>> take_limits(const Given& given, Given& rest) {
    std::vector<std::pair<const Rule*, double>> limits;
    const auto& sets = given.all("--set");
    for (std::size_t i = 0; i < sets.size(); ++i) {
        const auto equals = sets[i].find('='), dot = sets[i].substr(0, equals).find('.');
        const std::string place = "--set " + std::to_string(i + 1);
        const Rule* rule = dot == std::string::npos || equals == std::string::npos ? nullptr : find_rule(sets[i].substr(0, dot));
        if (rule == nullptr) {
            rest.add("--set", sets[i]);
            continue;
        }
        Settings settings({&rule->limit, 1});
        settings.set(sets[i].substr(dot + 1, equals - dot - 1), sets[i].substr(equals + 1), place, rule->name);
        limits.emplace_back(rule, settings.number(rule->limit.name));
    }
    return limits;
}

std::vector<Demand> demands_for(const Given& given, const Medium& medium,
                                const std::vector<std::pair<const Rule*, double>>& limits) {
    std::vector<Demand> demands;
    std::vector<const Rule*> wanted;
    for (const std::string& name : given.all("--rule")) wanted.push_back(&named_rule(name, "--rule"));
    const auto is_wanted = [&](const Rule* rule) {
        return wanted.empty() || std::find(wanted.begin(), wanted.end(), rule) != wanted.end();
    };
    for (const Rule* rule : wanted)
        if (!limit_of(*rule, medium))
            throw Error(Fault::usage, "--rule",
                        phrase("rule {0} is not about medium {1}; name another rule or medium", rule->name, medium.name));
    for (Demand demand : demands_of(medium)) {
        if (!is_wanted(demand.rule)) continue;
        for (const auto& [rule, limit] : limits)
            if (rule == demand.rule) demand.limit = limit;
        demands.push_back(demand);
    }
    for (const auto& [rule, limit] : limits)
        if (std::none_of(demands.begin(), demands.end(), [rule = rule](const Demand& demand) { return demand.rule == rule; }))
            throw Error(Fault::usage, "--set",
                        phrase("rule {0} is not checked here, so this would do nothing; leave it out", rule->name));
    return demands;
}

CheckTold told_value(const Given& given) {
    constexpr CheckTold kWays[] = {CheckTold::text, CheckTold::json, CheckTold::sarif, CheckTold::junit};
    if (given.has("--json") && given.value("--format", "json") != "json")
        throw Error(Fault::usage, "--json", phrase("give this or --format, not both"));
    if (given.has("--json")) return CheckTold::json;
    return kWays[choice_value(given, "--format", {"text", "json", "sarif", "junit"}).value_or(0)];
}

std::size_t most_value(const Given& given) {
    const std::string text = given.value("--most", "10");
    if (text == "all") return kAll;
    const auto number = parse_number(text);
    if (!number || *number < 0 || *number > 1e6 || *number != std::floor(*number))
        throw Error(Fault::usage, "--most",
                    phrase("it cannot be \"{0}\"; it is a whole number from 0 to 1000000, or all", text.substr(0, 80)));
    return static_cast<std::size_t>(*number);
}

Wanted plan_check(const Given& given) {
    Wanted wanted;
    wanted.files = given.words;
    if (wanted.files.empty()) throw Error(Fault::usage, "check", phrase("no page is named; for example: tactics check page.svg"));
    if (std::count(wanted.files.begin(), wanted.files.end(), "-") > 1)
        throw Error(Fault::usage, "check", phrase("standard input (-) is named twice; it can be read once"));
    const KeptSheet kept = kept_sheet(given);
    wanted.page.asks_medium = given.has("--medium");
    wanted.page.asks_margin = given.has("--margin");
    wanted.page.medium = given.has("--medium") || kept.medium == nullptr
                             ? &find_medium(given.value("--medium", "swell"), "--medium")
                             : kept.medium;
    // What is kept is of pages in print.
    const bool embossed = has_fixed_dots(*wanted.page.medium);
    wanted.page.paper = given.has("--paper") ? find_paper(given.value("--paper"), "--paper")
                        : embossed           ? kept.embosser_paper
                                             : kept.paper;
    if (given.has("--margin"))
        wanted.page.margin = length_value(given, "--margin", 0);
    else if (!embossed)
        wanted.page.margin = kept.margin;
    Given rest(kCheckFlags);
    for (const auto name : {"--recipe", "--filter", "--detail", "--no-defaults"})
        for (const auto& value : given.all(name)) rest.add(name, value);
    wanted.limits = take_limits(given, rest);
    wanted.page.chain = read_chain(rest, real_disk());
    wanted.page.table = table_wish(given);
    wanted.page.allowed = allowed_formats(given);
    wanted.page.pdf_page = page_value(given);
    if (given.has("--as-drawn")) wanted.page.chain.as_drawn = true;
    for (const std::string& name : given.all("--rule")) named_rule(name, "--rule");
    // What does not fit the medium is refused before a page is read, unless each page tells its own.
    if (wanted.page.asks_medium) demands_for(given, *wanted.page.medium, wanted.limits);
    wanted.told = told_value(given);
    wanted.most = most_value(given);
    wanted.strict = given.has("--strict");
    if (!given.has("--mark")) return wanted;
    wanted.mark = given.value("--mark");
    wanted.mark_format = format_of_path(wanted.mark);
    if (wanted.mark_format == nullptr)
        throw Error(Fault::usage, "--mark",
                    phrase("the name must end in .svg, .png or .pdf; write for example --mark marked.svg"));
    if (wanted.files.size() > 1) throw Error(Fault::usage, "--mark", phrase("this is for one page; check them one by one"));
    const Disk disk = real_disk();
    if (wanted.files[0] != "-" && disk.identity(wanted.files[0]) == disk.identity(wanted.mark))
        throw Error(Fault::usage, "--mark", phrase("this would replace the page itself; choose another name"));
    return wanted;
}

int run_check(const Given& given) {
    const Wanted wanted = plan_check(given);
    std::vector<Checked> all;
    int code = 0;
    bool broken = false;
    for (const std::string& file : wanted.files) {
        Checked checked{file, {}, wanted.page.medium, {}, ""};
        const Failure failure = failure_of(file == "-" ? "standard input" : file, [&] {
            checked.found = page_of(file, wanted.page);
            checked.medium = &medium_of(checked.found.page, wanted.page);
            checked.verdicts = check_page(checked.found.page, demands_for(given, *checked.medium, wanted.limits));
            if (wanted.mark_format != nullptr) write_file(wanted.mark, mark_page(checked, wanted.most, *wanted.mark_format));
        });
        checked.error = failure.text.english();
        if (!failure.text.empty()) {
            say(phrase("tactics: {0}", failure.text));
            code = std::max(code, static_cast<int>(failure.fault));
        }
        broken = broken || count_of(checked).hard > 0;
        if (wanted.told == CheckTold::json) print_out(json_report(checked));
        if (wanted.told == CheckTold::text && failure.text.empty())
            print_out(text_report(checked, wanted.most, wanted.mark_format != nullptr));
        if (wanted.told != CheckTold::sarif && wanted.told != CheckTold::junit) continue;
        checked.found.page = {};  // of many pages only the places are kept
        all.push_back(std::move(checked));
    }
    if (wanted.told == CheckTold::sarif) print_out(sarif_report(all));
    if (wanted.told == CheckTold::junit) print_out(junit_report(all));
    return code == 0 && wanted.strict && broken ? kRuleBroken : code;
}

}  // namespace

extern const Command check_command;
const Command check_command{
    .name = "check",
    .summary = "say where a page breaks the rules for tactile graphics",
    .words = "FILE...",
    .details =
        "FILE is a page in SVG or PDF, from any program, or - for SVG on standard input. Of a PDF, the first page is checked, "
        "read by the program pdftocairo. Any other picture is checked as the page that convert would make of it; --recipe, "
        "--filter, --detail and --as-drawn apply to these. That page is one sheet with the words that are read in the picture, "
        "but without title, labels and binding; to check a page that has more, check the SVG or PDF that convert writes.\n\n"
        "Each rule measures one thing on the page, in mm, against a limit with a source: tactics list rules, tactics help gap. "
        "A page must keep the hard rules to be usable; where it breaks another rule, a person should look. The rules measure "
        "only what can be measured; whether a drawing says what it should, only a reader's fingers can judge.\n\n"
        "Each line gives the file, the place from the top left corner, what is there, the limit, what to do and the rule. "
        "Contents that no rule measures, such as print letters, are reported as a note. In SVG, anything darker than mid-grey "
        "counts as black, and white drawn over black does not erase it.",
    .example =
        "tactics check page.svg\n"
        "tactics check pages/*.pdf --strict --json\n"
        "tactics check page.svg --mark marked.svg --set gap.least=6mm\n"
        "tactics check photo.jpg --recipe photo --medium thermoform",
    .flags = kCheckFlags,
    .offers = "files",
    .takes_kept = true,
    .run = run_check,
};

}  // namespace tactics
