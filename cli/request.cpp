// SPDX-License-Identifier: Apache-2.0
#include "cli/request.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "cli/chain.h"
#include "cli/choice_value.h"
#include "cli/files_from.h"
#include "cli/kept_choices.h"
#include "cli/labels.h"
#include "cli/language_choice.h"
#include "cli/model_flags.h"
#include "cli/outputs.h"
#include "cli/page_choices.h"
#include "cli/report/report.h"
#include "cli/sheet_values.h"
#include "cli/table_flags.h"
#include "filters/list.h"
#include "print/embosser.h"
#include "print/page_book.h"
#include "tactics/error.h"
#include "tactics/layout/place.h"
#include "tactics/units.h"

namespace tactics {

namespace {

Orientation orientation_value(const Given& given) {
    constexpr Orientation kAll[] = {Orientation::automatic, Orientation::portrait, Orientation::landscape};
    return kAll[choice_value(given, "--orientation", {"auto", "portrait", "landscape"}).value_or(0)];
}

void plan_scale(Sheet& sheet, const Given& given) {
    constexpr double kMost = 1e11;  // mm: two and a half times round the earth
    if (given.has("--real-width")) {
        sheet.real_width = length_value(given, "--real-width", 1e-3);
        if (*sheet.real_width > kMost)
            throw Error(Fault::usage, "--real-width", phrase("over 100,000 km there is no page to scale; give less"));
    }
    if (!given.has("--scale")) return;
    if (given.has("--width"))
        throw Error(Fault::usage, "--scale", phrase("the scale says how wide the drawing is; leave out --width or --scale"));
    sheet.scale = scale_value(given);
}

void plan_words(Request& request, const Given& given) {
    constexpr std::size_t kLongest = 10'000;  // bytes; as of a title
    request.sheet.description = given.value("--describe");
    const KeptValue* words = given.kept("words");
    request.words = words != nullptr ? find_words_wish(words->value, words->place)
                                     : find_words_wish(given.value("--words", "auto"), "--words");
    if (given.has("--describe") && request.items.size() > 1)
        throw Error(Fault::usage, "--describe", phrase("one text cannot describe several pictures; convert them one by one"));
    if (request.sheet.description.size() > kLongest)
        throw Error(Fault::usage, "--describe", phrase("the description is over 10000 bytes long; shorten it"));
}

// What any page has, a chart's too.
void plan_sheet(Request& request, const Given& given) {
    if (given.has("--paper")) request.paper = find_paper(given.value("--paper"), "--paper");
    if (given.has("--medium")) request.sheet.medium = &find_medium(given.value("--medium"), "--medium");
    request.sheet.orientation = orientation_value(given);
    if (given.has("--margin")) request.sheet.margin = length_value(given, "--margin", 0);
    request.sheet.title = given.value("--title");
    request.sheet.caption = given.value("--caption");
    request.sheet.print_title = !given.has("--no-print-title");
    plan_language(request.sheet, given, request.notes);
    request.asked = {given.has("--language"), given.has("--braille"), given.has("--cell")};
    request.kept = kept_sheet(given);
}

void plan_page(Request& request, const Given& given) {
    plan_sheet(request, given);
    if (given.has("--binding")) request.sheet.binding = binding_of(given.value("--binding"), "--binding");
    request.sheet.duplex = given.has("--duplex");
    request.sheet.tiles = tiles_value(given);
    if (given.has("--width")) request.sheet.drawing_width = length_value(given, "--width", 1);
    plan_scale(request.sheet, given);
    if (given.has("--cell")) request.sheet.cell = find_cell(given.value("--cell"), "--cell").size;
    request.sheet.bare = given.has("--bare");
    request.title_from_name = given.has("--title-from-name");
    if (request.title_from_name && !request.sheet.title.empty())
        throw Error(Fault::usage, "--title-from-name", phrase("give this or --title, not both"));
    if (request.sheet.bare && request.sheet.tiles.several())
        throw Error(Fault::usage, "--bare", phrase("the drawing alone is not cut into sheets; leave out --bare or --tiles"));
    if (request.sheet.bare && request.sheet.duplex)
        throw Error(Fault::usage, "--bare", phrase("the drawing alone has no back; leave out --bare or --duplex"));
    if (request.sheet.bare && request.sheet.binding)
        throw Error(Fault::usage, "--bare", phrase("the drawing alone is not bound; leave out --bare or --binding"));
    if (request.sheet.bare && (request.sheet.real_width || request.sheet.scale))
        throw Error(Fault::usage, "--bare",
                    phrase("the drawing alone has no scale bar; leave out --real-width and --scale, or --bare"));
    if (request.sheet.bare && !request.sheet.caption.empty())
        throw Error(Fault::usage, "--bare", phrase("the drawing alone has no caption; leave out --caption or --bare"));
    if (request.sheet.bare && (request.title_from_name || !request.sheet.title.empty()))
        throw Error(Fault::usage, "--bare", phrase("the drawing alone has no title; leave out --title or --bare"));
}

bool has_option(const Format& format, std::string_view name) {
    return std::any_of(format.options.begin(), format.options.end(), [&](const Option& option) { return option.name == name; });
}

Settings* find_settings(Request& request, std::string_view format) {
    for (auto& [written, settings] : request.settings)
        if (written->name == format) return &settings;
    return nullptr;
}

void plan_settings(Request& request) {
    for (const Item& item : request.items)
        for (const Output& output : item.outputs)
            if (find_settings(request, output.format->name) == nullptr)
                request.settings.push_back({output.format, Settings(output.format->options)});
}

void plan_dpi(Request& request, const Given& given) {
    if (!given.has("--dpi")) return;
    for (auto& [format, settings] : request.settings) {
        if (!has_option(*format, "dpi")) continue;
        settings.set("dpi", given.value("--dpi"), "--dpi", format->name);
        request.fixed_dpi = true;
    }
    if (!request.fixed_dpi)
        throw Error(Fault::usage, "--dpi",
                    phrase("no output is made of pixels, so this would do nothing; write a png or tiff, or leave it out"));
}

void plan_sets(Request& request, const Given& given) {
    const auto& sets = given.all("--set");
    for (std::size_t i = 0; i < sets.size(); ++i) {
        const Change change = parse_change(sets[i], "--set " + std::to_string(i + 1));
        const bool filter = find_filter(filters(), change.name) != nullptr;
        Settings* settings = find_settings(request, change.name);
        if (settings != nullptr) {
            settings->set(change.option, change.value, change.place, change.name);
            if (change.option == "dpi" || change.option == "width") request.fixed_dpi = true;
        } else if (!filter) {
            throw Error(Fault::usage, change.place,
                        phrase("no output is {0}, so this would do nothing; leave it out", change.name));
        }
    }
}

// Outputs named by a model get its settings, which are also recorded with the pages. The format does not distinguish two models
// of one driver.
MadeWith plan_models(Request& request, const std::vector<std::string>& outs, const std::vector<std::string>& to) {
    std::vector<std::pair<std::string, std::string>> named;  // and where
    for (const std::string& out : outs)
        if (const auto colon = out.find(':'); colon != std::string::npos) named.emplace_back(out.substr(0, colon), "-o " + out);
    for (const std::string& name : to) named.emplace_back(name, "--to");
    std::vector<std::pair<const Format*, std::string>> set;
    for (const auto& [name, place] : named) {
        const Format* format = find_format(name) != nullptr ? find_format(name) : find_model(name);
        Settings* settings = format == nullptr ? nullptr : find_settings(request, format->name);
        if (settings == nullptr || format->embosser == nullptr) continue;
        const std::string own(find_format(name) != nullptr ? "" : settings_of_model(name));
        for (const auto& [other, others] : set)
            if (other == format && others != own)
                throw Error(
                    Fault::usage, place,
                    phrase("another output is driven as {0} for another model; convert for one machine at a time", format->name));
        set.emplace_back(format, own);
        if (!own.empty()) set_model(*settings, name, place);
    }
    MadeWith models;
    for (const auto& [format, own] : set)
        if (!own.empty()) models.emplace_back("the machine's " + std::string(format->name), own);
    return models;
}

constexpr std::string_view kOfDrawings[] = {"--recipe", "--filter",     "--detail", "--as-drawn", "--subject", "--subject-only",
                                            "--leave",  "--label",      "--labels", "--words",    "--tiles",   "--width",
                                            "--scale",  "--real-width", "--bare",   "--model",    "--object",  "--save-recipe"};

// Its sheet and its dots for outputs that are of no machine.
void plan_machine(Request& request, const Given& given) {
    if (!given.has("--embosser")) return;
    const std::string name = given.value("--embosser");
    request.machine = &find_machine(name, "--embosser");
    if (given.has("--cell"))
        throw Error(Fault::usage, "--cell", phrase("{0} has braille of its own size; leave it out", request.machine->name));
    if (find_settings(request, request.machine->name) == nullptr)
        request.settings.push_back({request.machine, Settings(request.machine->options)});
    set_model(*find_settings(request, request.machine->name), name, "--embosser");
}

void plan_drawing(Request& request, const Given& given, const Disk& disk) {
    request.chain = read_chain(given, disk);
    if (given.has("--as-drawn")) request.chain.as_drawn = true;
    if (request.chain.base) request.recipe = finish(request.chain, *request.chain.base);
    plan_page(request, given);
    for (const Item& item : request.items)
        for (const Output& output : item.outputs)
            if (given.has("--cell") && output.format->dots != nullptr)
                throw Error(Fault::usage, "--cell", phrase("{0} has braille of its own size; leave it out", output.format->name));
    request.table = table_wish(given);
    request.model = model_wish(given);
    request.as_text = given.has("--text");
    if (request.as_text)
        for (const std::string_view flag : kOfDrawings)
            if (given.has(flag))
                throw Error(Fault::usage, flag, phrase("it is about drawings, and --text makes none; leave it out"));
    request.allowed = allowed_formats(given);
    plan_settings(request);
    plan_machine(request, given);
    request.workers = workers_value(given);
    plan_labels(request.items, given, disk);
    for (const Item& item : request.items) {
        check_subject(item.wish);
        if (request.recipe) with_subject(*request.recipe, item.wish);
    }
    const bool labelled =
        std::any_of(request.items.begin(), request.items.end(), [](const Item& item) { return !item.labels.empty(); });
    if (labelled && request.sheet.tiles.several() && request.sheet.braille_table.empty())
        throw Error(Fault::usage, "--tiles",
                    phrase("labels in print would be cut; leave out --braille none, the labels or --tiles"));
}

// Reports a margin that leaves nothing once, not for each picture. Ignores everything that depends on the picture's shape.
void check_sheets(const Request& request) {
    for (const auto& [format, settings] : request.settings) {
        Sheet sheet = sheet_for(request, *format, request.items.front());
        sheet.drawing_width.reset();
        sheet.scale.reset();
        if (request.title_from_name) sheet.title.clear();  // another for each picture
        place_on(sheet, 1);
    }
}

void plan_standard_output(const Request& request) {
    int users = request.answer != nullptr ? 1 : 0;
    if (request.save_recipe == "-") ++users;
    for (const Item& item : request.items)
        for (const Output& output : item.outputs)
            if (output.path == "-" && (!output.bound || &item == &request.items.front())) ++users;
    if (users > 1)
        throw Error(Fault::usage, "standard output",
                    phrase("only one can be written to it: a page, --json or --save-recipe; write the others to files"));
}

void plan_saving(Request& request, const Given& given, const Disk& disk) {
    request.save_recipe = given.value("--save-recipe");
    if (!given.has("--save-recipe")) return;
    if (request.save_recipe.empty()) throw Error(Fault::usage, "--save-recipe", phrase("the name of the file is missing"));
    if (!request.chain.base && request.items.size() > 1)
        throw Error(Fault::usage, "--save-recipe",
                    phrase("auto may choose another recipe for each picture; name one with --recipe, or convert one picture"));
    if (request.save_recipe == "-") return;
    const std::string identity = disk.identity(request.save_recipe);
    if (!request.chain.file.empty() && disk.identity(request.chain.file) == identity)
        throw Error(Fault::usage, "--save-recipe",
                    phrase("{0} is the recipe that is read, with its comments; choose another name", request.save_recipe));
    for (const Item& item : request.items) {
        bool taken = item.input != "-" && disk.identity(item.input) == identity;
        for (const Output& output : item.outputs) taken = taken || (output.path != "-" && disk.identity(output.path) == identity);
        if (taken)
            throw Error(Fault::usage, "--save-recipe",
                        phrase("{0} is a picture or an output; choose another name", request.save_recipe));
    }
}

}  // namespace

std::vector<std::string> named_outputs(const Given& given) {
    std::vector<std::string> outs = given.all("--output");
    const KeptValue* machine = given.kept("machine");
    for (std::string& out : outs)
        if (machine != nullptr && out.ends_with(".prn") && out.find(':') == std::string::npos) out = machine->value + ":" + out;
    return outs;
}

// Pages of one file must be of one size where its format wants that, whichever way up each picture is larger.
void turn_alike(Request& request) {
    if (request.sheet.orientation != Orientation::automatic) return;
    for (const Output& output : request.items.front().outputs) {
        if (!output.bound || holds_several_sizes(*output.format)) continue;
        request.sheet.orientation = Orientation::portrait;
        request.notes.push_back(
            phrase("{0} holds pages of one size, so all pages stand upright; --orientation landscape turns them", output.path));
        return;
    }
}

Request plan(const Given& given, const Disk& disk) {
    Request request;
    const std::vector<int> pages = pages_value(given);
    const std::vector<std::string> files = named_files(given);
    if (pages.size() > 1 && std::find(files.begin(), files.end(), "-") != files.end())
        throw Error(Fault::usage, "--page", phrase("standard input (-) can be read once; name one page, or the file"));
    const std::vector<std::string> outs = named_outputs(given);
    request.items = plan_outputs(files, outs, given.all("--to"), disk, pages, &request.notes);
    plan_drawing(request, given, disk);
    const MadeWith models = plan_models(request, outs, given.all("--to"));
    plan_words(request, given);
    plan_dpi(request, given);
    plan_sets(request, given);
    check_sheets(request);
    turn_alike(request);
    request.update = given.has("--update");
    request.made_with = page_choices(*find_command("convert"), given, request.chain);
    request.made_with->insert(request.made_with->end(), models.begin(), models.end());
    if (request.sheet.orientation != Orientation::automatic && !given.has("--orientation"))
        request.made_with->emplace_back("a file of one page size", "upright");
    if (given.has("--no-sync")) request.keep = Keep::by_system;
    request.loudness = loudness_value(given);
    request.progress = progress_value(given);
    request.strict = given.has("--strict");
    if (given.has("--json")) request.answer = [](const Outcome& outcome) { return result_json(outcome) + "\n"; };
    plan_saving(request, given, disk);
    plan_standard_output(request);
    return request;
}

Request plan_charts(std::vector<Item> items, const Given& given) {
    Request request;
    request.items = std::move(items);
    plan_sheet(request, given);
    plan_settings(request);
    plan_dpi(request, given);
    plan_sets(request, given);
    check_sheets(request);
    plan_standard_output(request);
    return request;
}

Request plan_pages(std::vector<Item> items, const Given& given, const Disk& disk) {
    Request request;
    request.items = std::move(items);
    request.page = page_value(given);
    plan_drawing(request, given, disk);
    plan_sets(request, given);
    check_sheets(request);
    return request;
}

Recipe saved_recipe(const Request& request) {
    const SubjectWish& wish = request.items.front().wish;
    const bool same =
        std::all_of(request.items.begin(), request.items.end(), [&](const Item& item) { return same_wish(item.wish, wish); });
    return same ? with_subject(request.recipe.value(), wish) : request.recipe.value();
}

}  // namespace tactics
