// SPDX-License-Identifier: Apache-2.0
// `tactics ppd`: an embosser as a printer of CUPS.
#include "cli/verbs/ppd.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "cli/command.h"
#include "cli/report/say.h"
#include "filters/list.h"
#include "print/embosser.h"
#include "tactics/braille/braille.h"
#include "tactics/braille/tables.h"
#include "tactics/error.h"
#include "tactics/layout/sheet.h"
#include "tactics/medium.h"
#include "tactics/units.h"

namespace tactics {

namespace {

std::string capital(std::string_view word) {
    std::string text(word);
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text;
}

std::string points(double mm) { return std::to_string(std::lround(mm / kMmPerPoint)); }

std::string choice_block(const std::string& key, const std::string& words, const std::vector<std::string>& choices,
                         std::string_view fallback) {
    std::string text = "*OpenUI *" + key + "/" + words + ": PickOne\n*Default" + key + ": " + std::string(fallback) + "\n";
    for (const std::string& choice : choices) text += "*" + key + " " + choice + "/" + choice + ": \"\"\n";
    return text + "*CloseUI: *" + key + "\n\n";
}

constexpr Flag kPpdFlags[] = {
    {"--filter", "", "PATH", "path of the program as a filter, if it is not installed in CUPS's own folder", false, "files"},
};

int run_ppd(const Given& given) {
    if (given.words.size() != 1) throw Error(Fault::usage, "ppd", phrase("name one embosser; see tactics list embossers"));
    print_out(ppd_of(find_embosser(given.words[0], "ppd"), given.value("--filter", kCupsFilterName)));
    return 0;
}

}  // namespace

std::string ppd_nick_of(std::string_view embosser) {
    return std::string(kPpdMaker) + " " + std::string(embosser) + ", tactile graphics";
}

std::string ppd_name_of(const Option& option) { return "Tactics" + capital(option.name); }

std::string ppd_size_of(const Paper& paper) { return paper.name == "11x17" ? "Tabloid" : capital(paper.name); }

std::string paper_of_ppd(std::string_view size) {
    for (const Paper& paper : papers())
        if (size == ppd_size_of(paper)) return std::string(paper.name);
    const auto h = size.find('h');
    if (size.size() < 4 || size[0] != 'w' || h == std::string_view::npos) return "";
    const auto width = parse_number(size.substr(1, h - 1)), height = parse_number(size.substr(h + 1));
    if (!width || !height) return "";
    return to_text(*width * kMmPerPoint) + "x" + to_text(*height * kMmPerPoint) + "mm";
}

namespace {

std::string head_of(const std::string& name) {
    return "*PPD-Adobe: \"4.3\"\n"
           "*FormatVersion: \"4.3\"\n"
           "*FileVersion: \"" TACTICS_VERSION
           "\"\n"
           "*LanguageVersion: English\n"
           "*LanguageEncoding: ISOLatin1\n"
           "*PCFileName: \"TACTICS.PPD\"\n"
           "*Manufacturer: \"TACTICS\"\n"
           "*Product: \"(" +
           name +
           ")\"\n"
           "*ModelName: \"TACTICS " +
           name +
           "\"\n"
           "*ShortNickName: \"" +
           std::string("TACTICS " + name).substr(0, 31) +
           "\"\n"
           "*NickName: \"" +
           ppd_nick_of(name) +
           "\"\n"
           "*PSVersion: \"(3010.000) 0\"\n"
           "*LanguageLevel: \"3\"\n"
           "*ColorDevice: False\n"
           "*DefaultColorSpace: Gray\n"
           "*FileSystem: False\n"
           "*Throughput: \"1\"\n"
           "*LandscapeOrientation: Plus90\n"
           "*TTRasterizer: Type42\n"
           "*cupsVersion: 2.4\n"
           "*cupsModelNumber: 0\n"
           "*cupsManualCopies: False\n"
           "*TacticsEmbosser: \"" +
           name + "\"\n";
}

// Which paper it takes, and what of that may be embossed.
std::string sizes_of(const Format& format) {
    const std::string name(format.name);
    const Medium& medium = find_medium(format.medium, name);
    std::vector<const Paper*> sizes;
    for (const Paper& paper : papers())
        if (takes_sheet(*format.embosser, Settings(format.options), paper.width, paper.height)) sizes.push_back(&paper);
    const std::string fallback = ppd_size_of(find_paper(format.paper, name));
    std::string text;
    const auto sizes_as = [&](const std::string& key, const auto& value) {
        for (const Paper* paper : sizes)
            text += "*" + key + " " + ppd_size_of(*paper) + "/" + std::string(paper->name) + ": \"" + value(*paper) + "\"\n";
    };
    for (const std::string key : {"PageSize", "PageRegion"}) {
        text += "\n*OpenUI *" + key + "/Paper: PickOne\n";
        if (key == "PageSize")
            text += "*OrderDependency: 10 AnySetup *PageSize\n";
        else
            text += "*OrderDependency: 10 AnySetup *PageRegion\n";
        text += "*Default" + key + ": " + fallback + "\n";
        sizes_as(key, [](const Paper& paper) {
            return "<</PageSize[" + points(paper.width) + " " + points(paper.height) + "]>>setpagedevice";
        });
        text += "*CloseUI: *" + key + "\n";
    }
    text += "\n*DefaultImageableArea: " + fallback + "\n";
    sizes_as("ImageableArea", [&](const Paper& paper) {
        return points(medium.margin) + " " + points(medium.margin) + " " + points(paper.width - medium.margin) + " " +
               points(paper.height - medium.margin);
    });
    text += "*DefaultPaperDimension: " + fallback + "\n";
    sizes_as("PaperDimension", [](const Paper& paper) { return points(paper.width) + " " + points(paper.height); });
    text += "\n";
    return text;
}

// Those that have a table of braille, by their tags.
std::vector<std::string> languages() {
    std::set<std::string> tags{"en"};
    const std::vector<BrailleTable> all = described_tables();
    for (const BrailleTable& table : all) {
        const std::string& first = table.languages.front();
        const std::string tag = first.substr(0, first.find('-'));
        if (tag.size() >= 2 && tag.size() <= 3 && !table_for_tag(tag, all).empty()) tags.insert(tag);
    }
    return {tags.begin(), tags.end()};
}

std::string choices_of(const Format& format) {
    std::string text;
    std::vector<std::string> recipes{"auto"};
    for (const NamedRecipe& recipe : named_recipes()) recipes.emplace_back(recipe.name);
    text += choice_block("TacticsRecipe", "Recipe", recipes, "auto");
    text += choice_block("TacticsDetail", "Detail", {"touch", "best", "contours", "0.5", "2"}, "touch");
    text += choice_block("TacticsLanguage", "Language", languages(), "en");
    text += choice_block("TacticsTitle", "Title", {"none", "job"}, "none");
    std::vector<std::string> tables{"auto", "none"};
    for (const std::string& table : braille_tables()) tables.push_back(table);
    text += choice_block("TacticsBraille", "Braille", tables, "auto");
    text += choice_block("TacticsWords", "Print in pictures", {"auto", "read", "leave", "remove"}, "auto");
    for (const Option& option : format.options) {
        if (option.type != Option::Type::choice) continue;
        std::vector<std::string> choices;
        for (const auto choice : choice_names(option)) choices.emplace_back(choice);
        text += choice_block(ppd_name_of(option), capital(option.name), choices,
                             choice_names(option)[static_cast<std::size_t>(option.fallback)]);
    }
    return text;
}

}  // namespace

std::string ppd_of(const Format& format, std::string_view filter) {
    std::string text = head_of(std::string(format.name));
    for (const std::string_view kind : {"application/pdf", "image/svg+xml", "image/png", "image/jpeg", "image/tiff"})
        text += "*cupsFilter2: \"" + std::string(kind) + " application/vnd.tactics 0 " + std::string(filter) + "\"\n";
    return text + sizes_of(format) + choices_of(format) +
           "*DefaultFont: Courier\n*Font Courier: Standard \"(1.05)\" Standard ROM\n";
}

extern const Command ppd_command;
const Command ppd_command{
    .name = "ppd",
    .summary = "print the PPD file that makes an embosser a CUPS printer",
    .words = "EMBOSSER",
    .details =
        "With a queue made from that file, any program can print to the embosser: PDF, SVG, PNG, JPEG and TIFF pages become "
        "tactile drawings as convert makes them. The options of the queue are TacticsRecipe, TacticsDetail, TacticsWords, "
        "TacticsLanguage, TacticsBraille (auto: that of the language), TacticsTitle (job: the name of the print job) and the "
        "machine's settings, such as TacticsPitch; lpoptions -p QUEUE -l lists them with their choices. A print job may also "
        "give any words as TacticsTitle, and labels for its one page as TacticsLabels=\"30%,40%=City Park;60%,20%=Lake\". It "
        "cannot name files, and any other option has no effect.\n\n"
        "CUPS calls the program as tacticstoembosser, which is installed in CUPS's filter folder. Where CUPS takes no driver "
        "files, the program tactics-printer-app makes the same printers without one.",
    .example =
        "tactics ppd index-v4 > index-v4.ppd\n"
        "lpadmin -p Everest -E -v socket://192.168.1.20:9100 -P index-v4.ppd\n"
        "lp -d Everest -o TacticsPitch=2.0 photo.jpg",
    .flags = kPpdFlags,
    .offers = "embossers",
    .run = run_ppd,
};

}  // namespace tactics
