// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/cups_driver.h"

#include "cli/report/say.h"
#include "cli/verbs/ppd.h"
#include "print/embosser.h"
#include "tactics/error.h"

namespace tactics {

namespace {

const std::string kScheme = std::string(kCupsDriverName) + "://";

// One line each: "URI" LANGUAGE "MAKE" "MODEL" "DEVICE ID". The id stays empty; tactics devices matches ids.
std::string listed_embossers() {
    std::string text;
    for (const Format* format : formats()) {
        if (format->embosser == nullptr || format->embosser->display != nullptr) continue;
        const std::string name(format->name);
        text += "\"" + kScheme + name + "\" en \"" + std::string(kPpdMaker) + "\" \"" + ppd_nick_of(name) + "\" \"\"\n";
    }
    return text;
}

}  // namespace

int run_cups_driver(std::span<const std::string> words) {
    if (words.size() == 1 && words[0] == "list") {
        print_out(listed_embossers());
        return 0;
    }
    if (words.size() == 2 && words[0] == "cat" && words[1].starts_with(kScheme)) {
        print_out(ppd_of(find_embosser(words[1].substr(kScheme.size()), words[1]), kCupsFilterName));
        return 0;
    }
    throw Error(Fault::usage, std::string(kCupsDriverName),
                phrase("CUPS starts it with list, or with cat and a URI from that list"));
}

}  // namespace tactics
