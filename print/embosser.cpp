// SPDX-License-Identifier: Apache-2.0
#include "print/embosser.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "print/format.h"
#include "tactics/error.h"
#include "tactics/text/utf8.h"
#include "tactics/text/words.h"
#include "tactics/units.h"

namespace tactics {

namespace {

// "Everest-D V5" in the form of an entry: everest-d-v5.
std::string typed(std::string_view name) {
    std::string small;
    for (char c : name) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
        const bool gap = c == ' ' || c == '_' || c == '-' || c == ',' || c == '.' || c == ';';
        if (!gap)
            small += c;
        else if (!small.empty() && small.back() != '-')
            small += '-';
    }
    if (small.ends_with('-')) small.pop_back();
    return small;
}

std::string_view called_in(const Embosser& embosser, std::string_view name) {
    const auto words = words_of(embosser.called);
    const auto found = std::find(words.begin(), words.end(), name);
    return found == words.end() ? std::string_view() : *found;
}

// "index-everest-d": what is before the model is a word of who makes it.
std::string_view called_with_maker(const Embosser& embosser, std::string_view name) {
    const std::string people = "-" + typed(embosser.models) + "-";
    for (auto gap = name.find('-'); gap != std::string_view::npos; gap = name.find('-', gap + 1))
        if (const std::string_view called = called_in(embosser, name.substr(gap + 1));
            !called.empty() && people.find("-" + std::string(name.substr(0, gap)) + "-") != std::string::npos)
            return called;
    return {};
}

struct FoundModel {
    const Format* format = nullptr;
    std::string_view called = {};
};

FoundModel look_up(std::string_view name) {
    const std::string model = typed(name.substr(0, 80));
    for (const auto& called : {called_in, called_with_maker})
        for (const Format* format : formats())
            if (format->embosser != nullptr)
                if (const std::string_view found = called(*format->embosser, model); !found.empty()) return {format, found};
    return {};
}

const Format& find_among(std::string_view name, std::string_view place, bool displays) {
    if (const Format* format = find_format(name); format != nullptr && format->embosser != nullptr) return *format;
    if (const Format* format = find_model(name)) return *format;
    std::vector<std::string_view> names;
    for (const Format* format : formats()) {
        if (format->embosser == nullptr || (!displays && format->embosser->display != nullptr)) continue;
        names.push_back(format->name);
        for (const std::string_view model : words_of(format->embosser->called)) names.push_back(model);
    }
    throw Error(
        Fault::usage, place,
        displays
            ? phrase(
                  "there is no embosser and no display of pins \"{0}\"{1}; see tactics list embossers and tactics list displays",
                  name.substr(0, 80), did_you_mean(name, names))
            : phrase("there is no embosser \"{0}\"{1}; see tactics list embossers", name.substr(0, 80),
                     did_you_mean(name, names)));
}

}  // namespace

const Format* find_model(std::string_view name) { return look_up(name).format; }

std::string_view settings_of_model(std::string_view name) {
    const FoundModel model = look_up(name);
    if (model.format != nullptr)
        for (const ModelSettings& own : model.format->embosser->settings_by_model)
            if (own.called == model.called) return own.settings;
    return {};
}

void set_model(Settings& settings, std::string_view name, std::string_view place) {
    for (const std::string_view setting : words_of(settings_of_model(name))) {
        const auto equals = setting.find('=');
        settings.set(setting.substr(0, equals), setting.substr(equals + 1), place, name);
    }
}

Phrase driven_as(std::string_view model, const Format& format) {
    const std::string_view settings = settings_of_model(model);
    const std::string name = to_line(model.substr(0, 80));
    return settings.empty() ? phrase("{0} is driven as {1}", name, format.name)
                            : phrase("{0} is driven as {1}, {2}", name, format.name, settings);
}

std::string_view own_paper(const Format& format, const Settings& settings) {
    const bool varies = format.embosser != nullptr && format.embosser->paper_of != nullptr;
    return varies ? format.embosser->paper_of(settings) : format.paper;
}

const Format& find_machine(std::string_view name, std::string_view place) { return find_among(name, place, true); }

const Format& find_embosser(std::string_view name, std::string_view place) {
    const Format& format = find_among(name, place, false);
    if (format.embosser->display != nullptr)
        throw Error(Fault::usage, place,
                    phrase("{0} is a display, which no paper goes through; use tactics show FILE {1} {0}:/dev/ttyUSB0", name,
                           spelled("on")));
    return format;
}

std::string taken_for(std::string_view id) {
    std::string small(id);
    for (char& c : small)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    std::string names;
    for (const Format* format : formats()) {
        if (format->embosser == nullptr) continue;
        const auto words = words_of(format->embosser->known_by);
        if (std::any_of(words.begin(), words.end(), [&](std::string_view word) { return small.find(word) != std::string::npos; }))
            names += (names.empty() ? "" : " or ") + std::string(format->name);
    }
    return names;
}

std::string_view packet_end(std::size_t packet, std::size_t bytes) {
    return packet > 0 && bytes > 0 && bytes % packet == 0 ? "\x1a" : "";
}

namespace {

constexpr double kSlip = 0.5;  // mm; papers by the inch

bool exceeds(double is, double most) { return most > 0 && is > most + kSlip; }

double widest_of(const Embosser& embosser, const Settings& settings) {
    return embosser.widest_of != nullptr ? embosser.widest_of(settings) : embosser.widest;
}

}  // namespace

bool takes_sheet(const Embosser& embosser, const Settings& settings, double width, double height) {
    return !exceeds(width, widest_of(embosser, settings)) && !exceeds(height, embosser.longest);
}

void check_sheet(const Embosser& embosser, const Settings& settings, std::string_view name, double width, double height) {
    const auto refuse = [&](std::string_view what, double is, double most) {
        throw Error(Fault::usage, name,
                    phrase("the sheet is {0} mm {1}, and this machine takes {2} mm; choose a smaller {3} or another {4}; {5} "
                           "makes a large page of several sheets",
                           to_text(std::round(is * 10) / 10), what, to_text(most), spelled("paper"), spelled("orientation"),
                           spelled("tiles")));
    };
    const double widest = widest_of(embosser, settings);
    if (exceeds(width, widest)) refuse("wide", width, widest);
    if (exceeds(height, embosser.longest)) refuse("long", height, embosser.longest);
}

}  // namespace tactics
