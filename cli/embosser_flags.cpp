// SPDX-License-Identifier: Apache-2.0
#include "cli/embosser_flags.h"

#include "cli/chain.h"
#include "cli/kept_choices.h"
#include "cli/report/say.h"
#include "print/embosser.h"
#include "tactics/error.h"

namespace tactics {

const Format* machine_of(const Given& given, MachineKinds kinds) {
    const bool typed = given.has("--embosser");
    const KeptValue* kept = given.kept("machine");
    if (!typed) return kept == nullptr ? nullptr : &find_embosser(kept->value, kept->place);
    const std::string name = given.value("--embosser");
    const Format& format =
        kinds == MachineKinds::with_displays ? find_machine(name, "--embosser") : find_embosser(name, "--embosser");
    if (name != format.name) say(driven_as(name, format));
    return &format;
}

Paper sheet_in(const Given& given, const Format* format, const Settings& settings) {
    if (given.has("--paper")) return find_paper(given.value("--paper"), "--paper");
    Sheet sheet;
    sheet.paper = find_paper(format == nullptr ? "a4" : own_paper(*format, settings), "--paper");
    if (format != nullptr) take_kept(sheet, kept_sheet(given), *format, false, settings);
    return sheet.paper;
}

Settings embosser_settings(const Format& format, const Given& given) {
    Settings settings(format.options);
    const KeptValue* kept = given.kept("machine");
    if (given.has("--embosser"))
        set_model(settings, given.value("--embosser"), "--embosser");
    else if (kept != nullptr)
        set_model(settings, kept->value, kept->place);
    for (const std::string& text : given.all("--set")) {
        const Change change = parse_change(text, "--set");
        if (change.name != format.name)
            throw Error(Fault::usage, "--set", phrase("it is {0}.OPTION=VALUE; see tactics help {0}", format.name));
        settings.set(change.option, change.value, change.place, change.name);
    }
    return settings;
}

}  // namespace tactics
