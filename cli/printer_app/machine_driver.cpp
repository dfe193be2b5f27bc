// SPDX-License-Identifier: Apache-2.0
#include "cli/printer_app/machine_driver.h"

#include <algorithm>

#include "cli/verbs/ppd.h"
#include "tactics/text/words.h"

namespace tactics {

namespace {

constexpr std::string_view kAnyWords[] = {"TacticsTitle", "TacticsLabels"};

Settings settings_of(const MachineDriver& driver) {
    Settings settings(driver.format->options);
    set_model(settings, driver.name, driver.name);
    return settings;
}

}  // namespace

const std::vector<MachineDriver>& machine_drivers() {
    static const std::vector<MachineDriver> kDrivers = [] {
        std::vector<MachineDriver> drivers;
        const auto add = [&](std::string_view name, const Format* format) {
            drivers.push_back({std::string(name), ppd_nick_of(name), format});
        };
        for (const Format* format : formats()) {
            if (format->embosser == nullptr || format->embosser->display != nullptr) continue;
            if (format->name == "viewplus") continue;  // it raises dots by its own driver only, from a picture
            add(format->name, format);
            for (const std::string_view model : words_of(format->embosser->called)) add(model, format);
        }
        return drivers;
    }();
    return kDrivers;
}

const MachineDriver* find_driver(std::string_view name) {
    const auto& all = machine_drivers();
    const auto found = std::find_if(all.begin(), all.end(), [&](const MachineDriver& driver) { return driver.name == name; });
    return found == all.end() ? nullptr : &*found;
}

const MachineDriver* driver_of_device(std::string_view id) { return find_driver(taken_for(id)); }

PpdWords words_of(const MachineDriver& driver) {
    PpdWords words = parse_ppd(ppd_of(*driver.format, kCupsFilterName));
    const Settings settings = settings_of(driver);
    for (const Option& option : driver.format->options)
        for (auto& [name, value] : words.defaults)
            if (name == ppd_name_of(option)) value = settings.text(option.name);
    for (auto& [name, value] : words.defaults)
        if (name == "PageSize" || name == "PageRegion") value = ppd_size_of(papers_of(driver).front());
    return words;
}

std::vector<Paper> papers_of(const MachineDriver& driver) {
    const Settings settings = settings_of(driver);
    std::vector<Paper> taken{find_paper(own_paper(*driver.format, settings), driver.name)};
    for (const Paper& paper : papers())
        if (paper.name != taken.front().name && takes_sheet(*driver.format->embosser, settings, paper.width, paper.height))
            taken.push_back(paper);
    return taken;
}

std::string attribute_of(std::string_view option) {
    constexpr std::string_view kOurs = "Tactics";
    if (option == "TacticsLabels") return "tactics-label";
    std::string name = "tactics-";
    for (const char c : option.substr(option.starts_with(kOurs) ? kOurs.size() : 0))
        name += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return name;
}

PrintOptions own_options(const PpdWords& words) {
    PrintOptions own;
    std::copy_if(words.defaults.begin(), words.defaults.end(), std::back_inserter(own),
                 [](const auto& option) { return option.first.starts_with("Tactics"); });
    return own;
}

std::string in_attributes(std::string message, const PpdWords& words) {
    std::vector<std::string> options(std::begin(kAnyWords), std::end(kAnyWords));
    for (const auto& option : own_options(words)) options.push_back(option.first);
    for (const std::string& option : options)
        for (auto at = message.find(option); at != message.npos; at = message.find(option, at))
            message.replace(at, option.size(), attribute_of(option));
    return message;
}

bool takes_any_words(std::string_view option) {
    return std::find(std::begin(kAnyWords), std::end(kAnyWords), option) != std::end(kAnyWords);
}

}  // namespace tactics
