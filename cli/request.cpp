// SPDX-License-Identifier: Apache-2.0
#include "cli/request.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "cli/chain.h"
#include "cli/choice_value.h"
#include "cli/files_from.h"
#include "cli/labels.h"
#include "cli/model_flags.h"
#include "cli/outputs.h"
#include "cli/report/report.h"
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

std::optional<Binding> binding_value(const Given& given) {
    if (!given.has("--binding")) return std::nullopt;
    const std::string text = given.value("--binding");
    const auto equals = text.find('=');
    const std::string edge = text.substr(0, equals);
    const auto room = parse_length(equals == std::string::npos ? "" : text.substr(equals + 1));
    if ((edge != "left" && edge != "top" && edge != "right") || !room || *room < 0)
        throw Error(Fault::usage, "--binding",
                    "it cannot be \"" + text.substr(0, 80) + "\"; it is left, top or right with a length, such as left=15mm");
    return Binding{edge == "left" ? Binding::Edge::left : edge == "top" ? Binding::Edge::top : Binding::Edge::right, *room};
}

Tiles tiles_value(const Given& given) {
    const std::string text = given.value("--tiles", "1x1");
    const auto is_count = [](char c) { return c >= '1' && c <= '9'; };
    if (text.size() != 3 || !is_count(text[0]) || text[1] != 'x' || !is_count(text[2]))
        throw Error(Fault::usage, "--tiles",
                    "it cannot be \"" + text.substr(0, 80) + "\"; it is columns x rows of sheets, such as 2x2, at most 9x9");
    return {text[0] - '0', text[2] - '0'};
}

// Mm on the page for a mm in the world: "1:100", "1cm=1m".
double scale_value(const Given& given) {
    const std::string text = given.value("--scale");
    const auto colon = text.find(':'), equals = text.find('=');
    std::optional<double> page, world;
    if (colon != std::string::npos) {
        page = parse_number(text.substr(0, colon));
        world = parse_number(text.substr(colon + 1));
    } else if (equals != std::string::npos) {
        page = parse_length(text.substr(0, equals));
        world = parse_length(text.substr(equals + 1));
    }
    constexpr double kMost = 1e12;  // the earth fits on a page
    const double scale = page && world ? *page / *world : 0;
    if (!page || !world || !(*page > 0) || !(*world > 0) || !(scale > 1 / kMost && scale < kMost))
        throw Error(Fault::usage, "--scale",
                    "it cannot be \"" + text.substr(0, 80) +
                        "\"; it is a ratio such as 1:100, or a length on the page and one in the "
                        "world, such as 1cm=1m");
    return scale;
}

void plan_scale(Sheet& sheet, const Given& given) {
    constexpr double kMost = 1e11;  // mm: two and a half times round the earth
    if (given.has("--real-width")) {
        sheet.real_width = length_value(given, "--real-width", 1e-3);
        if (*sheet.real_width > kMost)
            throw Error(Fault::usage, "--real-width", "over 100,000 km there is no page to scale; give less");
    }
    if (!given.has("--scale")) return;
    if (given.has("--width"))
        throw Error(Fault::usage, "--scale", "the scale says how wide the drawing is; leave out --width or --scale");
    sheet.scale = scale_value(given);
}

// BCP 47 (RFC 5646): a language of 2 to 8 letters, then parts of 1 to 8 letters or digits. What they mean is not looked up.
bool is_language(std::string_view tag) {
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    std::size_t at = 0;
    for (bool first = true; at <= tag.size(); first = false) {
        const std::string_view part = tag.substr(at, tag.find('-', at) - at);
        if (part.size() < (first ? 2u : 1u) || part.size() > 8) return false;
        for (const char c : part)
            if (!is_letter(c) && (first || c < '0' || c > '9')) return false;
        at += part.size() + 1;
    }
    return true;
}

void plan_language(Request& request, const Given& given) {
    request.sheet.language = given.value("--language", request.sheet.language);
    if (!is_language(request.sheet.language))
        throw Error(
            Fault::usage, "--language",
            "it cannot be \"" + request.sheet.language.substr(0, 80) + "\"; it is a language tag such as en, en-GB or de");
}

void plan_words(Request& request, const Given& given) {
    constexpr std::size_t kLongest = 10'000;  // bytes; as of a title
    request.sheet.description = given.value("--describe");
    plan_language(request, given);
    request.words = find_words_wish(given.value("--words", "auto"), "--words");
    if (given.has("--describe") && request.items.size() > 1)
        throw Error(Fault::usage, "--describe", "one text cannot describe several pictures; convert them one by one");
    if (request.sheet.description.size() > kLongest)
        throw Error(Fault::usage, "--describe", "the description is over 10000 bytes long; shorten it");
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
    const std::string table = given.value("--braille", request.sheet.braille_table);
    request.sheet.braille_table = table == "none" ? "" : table;
}

void plan_page(Request& request, const Given& given) {
    plan_sheet(request, given);
    request.sheet.binding = binding_value(given);
    request.sheet.duplex = given.has("--duplex");
    request.sheet.tiles = tiles_value(given);
    if (given.has("--width")) request.sheet.drawing_width = length_value(given, "--width", 1);
    plan_scale(request.sheet, given);
    if (given.has("--cell")) request.sheet.cell = find_cell(given.value("--cell"), "--cell").size;
    request.sheet.bare = given.has("--bare");
    request.title_from_name = given.has("--title-from-name");
    if (request.title_from_name && !request.sheet.title.empty())
        throw Error(Fault::usage, "--title-from-name", "give this or --title, not both");
    if (request.sheet.bare && request.sheet.tiles.several())
        throw Error(Fault::usage, "--bare", "the drawing alone is not cut into sheets; leave out --bare or --tiles");
    if (request.sheet.bare && request.sheet.duplex)
        throw Error(Fault::usage, "--bare", "the drawing alone has no back; leave out --bare or --duplex");
    if (request.sheet.bare && request.sheet.binding)
        throw Error(Fault::usage, "--bare", "the drawing alone is not bound; leave out --bare or --binding");
    if (request.sheet.bare && (request.sheet.real_width || request.sheet.scale))
        throw Error(Fault::usage, "--bare", "the drawing alone has no scale bar; leave out --real-width and --scale, or --bare");
    if (request.sheet.bare && !request.sheet.caption.empty())
        throw Error(Fault::usage, "--bare", "the drawing alone has no caption; leave out --caption or --bare");
    if (request.sheet.bare && (request.title_from_name || !request.sheet.title.empty()))
        throw Error(Fault::usage, "--bare", "the drawing alone has no title; leave out --title or --bare");
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
                    "no output is made of pixels, so this would do nothing; write a png or tiff, or leave it out");
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
            throw Error(Fault::usage, change.place, "no output is " + change.name + ", so this would do nothing; leave it out");
        }
    }
}

constexpr std::string_view kOfDrawings[] = {"--recipe", "--filter",     "--detail", "--as-drawn", "--subject", "--subject-only",
                                            "--leave",  "--label",      "--labels", "--words",    "--tiles",   "--width",
                                            "--scale",  "--real-width", "--bare",   "--model",    "--object",  "--save-recipe"};

void plan_drawing(Request& request, const Given& given, const Disk& disk) {
    request.chain = read_chain(given, disk);
    if (given.has("--as-drawn")) request.chain.as_drawn = true;
    if (request.chain.base) request.recipe = finish(request.chain, *request.chain.base);
    plan_page(request, given);
    for (const Item& item : request.items)
        for (const Output& output : item.outputs)
            if (given.has("--cell") && output.format->dots != nullptr)
                throw Error(Fault::usage, "--cell",
                            std::string(output.format->name) + " has braille of its own size; leave it out");
    request.table = table_wish(given);
    request.model = model_wish(given);
    request.as_text = given.has("--text");
    if (request.as_text)
        for (const std::string_view flag : kOfDrawings)
            if (given.has(flag)) throw Error(Fault::usage, flag, "it is about drawings, and --text makes none; leave it out");
    request.allowed = allowed_formats(given);
    plan_settings(request);
    request.workers = workers_value(given);
    plan_labels(request.items, given, disk);
    for (const Item& item : request.items) {
        check_subject(item.wish);
        if (request.recipe) with_subject(*request.recipe, item.wish);
    }
    const bool labelled =
        std::any_of(request.items.begin(), request.items.end(), [](const Item& item) { return !item.labels.empty(); });
    if (labelled && request.sheet.tiles.several() && request.sheet.braille_table.empty())
        throw Error(Fault::usage, "--tiles", "labels in print would be cut; leave out --braille none, the labels or --tiles");
}

// A margin that leaves nothing is told once, not for each picture. What depends on the picture's shape is left out.
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
                    "only one can be written to it: a page, --json or --save-recipe; write the others to files");
}

void plan_saving(Request& request, const Given& given, const Disk& disk) {
    request.save_recipe = given.value("--save-recipe");
    if (!given.has("--save-recipe")) return;
    if (request.save_recipe.empty()) throw Error(Fault::usage, "--save-recipe", "the name of the file is missing");
    if (!request.chain.base && request.items.size() > 1)
        throw Error(Fault::usage, "--save-recipe",
                    "auto may choose another recipe for each picture; name one with --recipe, or convert one picture");
    if (request.save_recipe == "-") return;
    const std::string identity = disk.identity(request.save_recipe);
    if (!request.chain.file.empty() && disk.identity(request.chain.file) == identity)
        throw Error(Fault::usage, "--save-recipe",
                    request.save_recipe + " is the recipe that is read, with its comments; choose another name");
    for (const Item& item : request.items) {
        bool taken = item.input != "-" && disk.identity(item.input) == identity;
        for (const Output& output : item.outputs) taken = taken || (output.path != "-" && disk.identity(output.path) == identity);
        if (taken)
            throw Error(Fault::usage, "--save-recipe", request.save_recipe + " is a picture or an output; choose another name");
    }
}

}  // namespace

// Pages of one file must be of one size where its format wants that, whichever way up each picture is larger.
void turn_alike(Request& request) {
    if (request.sheet.orientation != Orientation::automatic) return;
    for (const Output& output : request.items.front().outputs) {
        if (!output.bound || holds_several_sizes(*output.format)) continue;
        request.sheet.orientation = Orientation::portrait;
        request.notes.push_back(output.path +
                                " holds pages of one size, so all pages stand upright; --orientation landscape turns them");
        return;
    }
}

Request plan(const Given& given, const Disk& disk) {
    Request request;
    const std::vector<int> pages = pages_value(given);
    const std::vector<std::string> files = named_files(given);
    if (pages.size() > 1 && std::find(files.begin(), files.end(), "-") != files.end())
        throw Error(Fault::usage, "--page", "standard input (-) can be read once; name one page, or the file");
    request.items = plan_outputs(files, given.all("--output"), given.all("--to"), disk, pages, &request.notes);
    plan_drawing(request, given, disk);
    plan_words(request, given);
    plan_dpi(request, given);
    plan_sets(request, given);
    check_sheets(request);
    turn_alike(request);
    request.update = given.has("--update");
    if (given.has("--no-sync")) request.keep = Keep::by_system;
    request.loudness = loudness_value(given);
    request.progress = progress_value(given);
    request.check_rules = given.has("--strict");
    if (given.has("--json")) request.answer = [](const Outcome& outcome) { return result_json(outcome) + "\n"; };
    plan_saving(request, given, disk);
    plan_standard_output(request);
    return request;
}

Request plan_charts(std::vector<Item> items, const Given& given) {
    Request request;
    request.items = std::move(items);
    plan_sheet(request, given);
    plan_language(request, given);
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
