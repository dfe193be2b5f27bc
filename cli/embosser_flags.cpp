// SPDX-License-Identifier: Apache-2.0
#include "cli/embosser_flags.h"

#include "cli/chain.h"
#include "print/embosser.h"
#include "tactics/error.h"

namespace tactics {

Settings embosser_settings(const Format& format, const Given& given) {
    Settings settings(format.options);
    for (const std::string& text : given.all("--set")) {
        const Change change = parse_change(text, "--set");
        if (change.name != format.name)
            throw Error(Fault::usage, "--set",
                        "it is " + std::string(format.name) + ".OPTION=VALUE; see tactics help " + std::string(format.name));
        settings.set(change.option, change.value, change.place, change.name);
    }
    return settings;
}

}  // namespace tactics
