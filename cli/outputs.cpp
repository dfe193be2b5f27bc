// SPDX-License-Identifier: Apache-2.0
#include "cli/outputs.h"

#include <algorithm>
#include <map>
#include <optional>

#include "print/embosser.h"
#include "tactics/error.h"
#include "tactics/text/words.h"

namespace tactics {

namespace {

std::vector<std::string_view> format_names() {
    std::vector<std::string_view> names;
    for (const Format* format : formats()) {
        names.push_back(format->name);
        if (format->embosser == nullptr) continue;
        for (const std::string_view model : words_of(format->embosser->called)) names.push_back(model);
    }
    return names;
}

// A format, or a machine by its model, with a note on its driver.
const Format* format_called(std::string_view name, std::vector<Phrase>& told) {
    if (const Format* format = find_format(name)) return format;
    const Format* format = find_model(name);
    if (format != nullptr) told.push_back(driven_as(name, *format));
    return format;
}

const Format& named_format(std::string_view name, std::string_view place, std::vector<Phrase>& told) {
    if (const Format* format = format_called(name, told)) return *format;
    throw Error(Fault::usage, place,
                phrase("there is no format \"{0}\"{1}; see tactics list formats", name.substr(0, 80),
                       did_you_mean(name, format_names())));
}

// One -o, taken apart.
struct Wish {
    const Format* format = nullptr;  // as named by the user; nullptr: the ending or --to says
    std::string path;
    bool folder = false;
};

Wish read_wish(const std::string& out, const Disk& disk, std::vector<Phrase>& told) {
    Wish wish{nullptr, out, false};
    const auto colon = out.find(':');
    if (colon != std::string::npos) {
        wish.format = format_called(out.substr(0, colon), told);
        if (wish.format != nullptr) wish.path = out.substr(colon + 1);
    }
    if (wish.path.empty()) throw Error(Fault::usage, "-o " + out, phrase("the name of a file or folder is missing"));
    if (const auto end = wish.path.find_last_not_of('/'); wish.path.back() == '/' && end != std::string::npos) {
        const std::string name = wish.path.substr(0, end + 1);
        if (disk.exists(name) && !disk.is_folder(name))
            throw Error(Fault::usage, "-o " + out,
                        phrase("{0} is a file, so it cannot be a folder; choose another name for the folder, or leave out the / "
                               "to replace the file",
                               name));
    }
    wish.folder = wish.path != "-" && (wish.path.back() == '/' || disk.is_folder(wish.path));
    if (wish.folder || wish.format != nullptr) return wish;

    wish.format = format_of_path(wish.path);
    if (wish.format != nullptr) return wish;
    const std::string place = "-o " + out;
    if (out == "-") throw Error(Fault::usage, place, phrase("name the format for standard output, for example -o pdf:-"));
    if (colon != std::string::npos && out.find('/') > colon) named_format(out.substr(0, colon), place, told);
    if (out.ends_with(".prn"))
        throw Error(Fault::usage, place,
                    phrase("an embosser's file is for one machine; name it, as in index-v4:{0}, or keep one: tactics defaults "
                           "set machine index-v4",
                           out));
    const auto dot = out.rfind('.');
    const bool ending = dot != std::string::npos && out.find('/', dot) == std::string::npos;
    throw Error(Fault::usage, place,
                ending ? phrase("the ending {0} names no format{1}; end it in .pdf or another of tactics list formats, write "
                                "pdf:{2}, or end a folder in /",
                                out.substr(dot).substr(0, 40), did_you_mean(out.substr(dot + 1), format_names()), out)
                       : phrase("this is no folder and its name has no ending; end it in .pdf or another of tactics list "
                                "formats, write pdf:{0}, or end a folder in /",
                                out));
}

std::string extension_of(const Format& format) {
    const auto extensions = words_of(format.extensions);
    return "." + std::string(extensions.empty() ? format.name : extensions[0]);
}

std::string shown(const std::string& path, std::string_view dash) { return path == "-" ? std::string(dash) : path; }

// One file of all items.
bool binds(const Item& item, const std::string& identity, const Disk& disk) {
    return std::any_of(item.outputs.begin(), item.outputs.end(), [&](const Output& output) {
        return output.bound && (output.path == "-" ? "-" : disk.identity(output.path)) == identity;
    });
}

void refuse_losses(const std::vector<Item>& items, const Disk& disk) {
    std::map<std::string, std::string> pictures;  // identity of the file -> as the user wrote it
    std::map<std::string, const Item*> made_from;
    for (const Item& item : items)
        if (item.input != "-") pictures.emplace(disk.identity(item.input), item.input);
    for (const Item& item : items) {
        for (const Output& output : item.outputs) {
            const std::string identity = output.path == "-" ? "-" : disk.identity(output.path);
            const auto picture = pictures.find(identity);
            if (picture != pictures.end())
                throw Error(Fault::usage, output.path,
                            phrase("this would replace the picture {0}; choose another name or folder", picture->second));
            const auto [other, fresh] = made_from.emplace(identity, &item);
            if (fresh || (output.bound && other->second != &item && binds(*other->second, identity, disk))) continue;
            const std::string name = shown(output.path, "standard output");
            if (other->second == &item) throw Error(Fault::usage, "-o", phrase("{0} is named twice; name it once", name));
            if (other->second->input == item.input)
                throw Error(Fault::usage, item.input, phrase("this picture is named twice; name it once"));
            throw Error(Fault::usage, "-o",
                        phrase("{0} and {1} would both be written to {2}; convert them into different folders or rename one",
                               other->second->input, item.input, name));
        }
    }
}

void check_named(const std::vector<std::string>& inputs, const std::vector<std::string>& outs) {
    if (inputs.empty())
        throw Error(Fault::usage, "convert", phrase("no picture is named; for example: tactics convert photo.jpg -o photo.pdf"));
    if (outs.empty()) {
        const std::string name = inputs.size() == 1 ? stem_of(inputs[0]) + ".pdf" : std::string("pages/");
        throw Error(Fault::usage, "convert", phrase("where to write is missing; add for example -o {0}", name));
    }
    if (std::find(inputs.begin(), inputs.end(), "") != inputs.end())
        throw Error(Fault::usage, "\"\"", phrase("the name of a picture is empty; name a file, or - for standard input"));
    if (std::count(inputs.begin(), inputs.end(), "-") > 1)
        throw Error(Fault::usage, "convert", phrase("standard input (-) is named twice; it can be read once"));
}

}  // namespace

std::vector<Item> plan_outputs(const std::vector<std::string>& inputs, const std::vector<std::string>& outs,
                               const std::vector<std::string>& to, const Disk& disk, const std::vector<int>& pages,
                               std::vector<Phrase>* notes) {
    std::vector<Phrase> unheard;
    std::vector<Phrase>& told = notes != nullptr ? *notes : unheard;
    check_named(inputs, outs);
    std::vector<const Format*> folder_formats;
    for (const auto& name : to) {
        const Format* format = &named_format(name, "--to", told);
        if (std::find(folder_formats.begin(), folder_formats.end(), format) == folder_formats.end())
            folder_formats.push_back(format);
    }
    if (folder_formats.empty()) folder_formats.push_back(find_format("pdf"));

    const bool several = inputs.size() > 1 || pages.size() > 1;
    std::vector<Wish> wishes;
    bool to_is_used = to.empty();
    for (const auto& out : outs) {
        wishes.push_back(read_wish(out, disk, told));
        const Wish& wish = wishes.back();
        to_is_used = to_is_used || (wish.folder && wish.format == nullptr);
        if (!wish.folder && several && wish.format->encode_pages == nullptr)
            throw Error(Fault::usage, "-o " + out,
                        inputs.size() > 1 ? phrase("{0} holds one page, and there are several pictures; name a folder, which "
                                                   "ends in /, for example -o pages/, or a pdf, which holds all",
                                                   wish.format->name)
                                          : phrase("{0} holds one page, and there are several pages of a PDF; name a folder, "
                                                   "which ends in /, for example -o pages/, or a pdf, which holds all",
                                                   wish.format->name));
    }
    if (!to_is_used)
        throw Error(Fault::usage, "--to",
                    phrase("it names the formats for a folder, and no -o is a folder; end a folder's name in /"));

    std::vector<Item> items;
    for (std::size_t i = 0; i < inputs.size() * pages.size(); ++i) {
        const std::string& input = inputs[i / pages.size()];
        Item item{input, {}};
        item.pdf_page = pages[i % pages.size()];
        for (const Wish& wish : wishes) {
            if (!wish.folder) {
                item.outputs.push_back({wish.format, wish.path, "", several});
                continue;
            }
            const std::string base = wish.path + (wish.path.back() == '/' ? "" : "/") + stem_of(input) +
                                     (pages.size() > 1 ? "-page" + std::to_string(item.pdf_page) : "");
            const std::vector<const Format*> named{wish.format};
            for (const Format* format : wish.format == nullptr ? folder_formats : named)
                item.outputs.push_back({format, base + extension_of(*format), wish.path});
        }
        items.push_back(std::move(item));
    }
    refuse_losses(items, disk);
    return items;
}

}  // namespace tactics
