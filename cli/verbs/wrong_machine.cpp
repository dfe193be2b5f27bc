// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/wrong_machine.h"

#include <algorithm>

#include "print/embosser.h"
#include "tactics/error.h"

namespace tactics {

namespace {

// With dots and a set-up: text alone is understood by many.
bool understands_all(const Format& format, std::string_view bytes) {
    const Punched punched = format.embosser->punch(bytes, Settings(format.options));
    return punched.notes.empty() && std::any_of(punched.sheets.begin(), punched.sheets.end(), [](const PunchedSheet& sheet) {
               return !sheet.dots.empty() && sheet.set_up_end > sheet.set_up_begin;
           });
}

}  // namespace

void refuse_wrong_machine(const std::string& name, std::string_view bytes, const Format& format, const Settings& settings) {
    const Punched punched = format.embosser->punch(bytes, settings);
    if (punched.notes.empty()) return;
    std::vector<Phrase> others;
    std::string first;
    for (const Format* other : formats()) {
        if (other == &format || other->embosser == nullptr || other->embosser->punch == nullptr) continue;
        if (!understands_all(*other, bytes)) continue;
        if (first.empty()) first = other->name;
        others.push_back(other->name);
    }
    if (others.empty()) return;
    throw Error(Fault::usage, name,
                phrase("these bytes are for {0}: {1} would not understand {2}; if that is the machine, add {3} {4}, else convert "
                       "the picture for {1}",
                       either_of(others), format.name, punched.notes.front(), spelled("embosser"), first));
}

}  // namespace tactics
