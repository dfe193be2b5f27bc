// SPDX-License-Identifier: Apache-2.0
#include "cli/embosser_flags.h"

#include "cli/chain.h"
#include "print/embosser.h"
#include "tactics/error.h"
#include "tactics/readers/read.h"

namespace tactics {

void append_file(std::string& bytes, const std::string& name) {
    constexpr std::size_t kMost = 256u << 20;
    const Source source = open_source(name);
    char block[1 << 16];
    while (const std::size_t count = std::fread(block, 1, sizeof block, source.file.get())) {
        bytes.append(block, count);
        if (bytes.size() > kMost)
            throw Error(Fault::failed, name, "is over 256 MB with what stands before it; take fewer files at a time");
    }
}

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
