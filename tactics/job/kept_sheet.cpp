// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/kept_sheet.h"

#include "print/embosser.h"

namespace tactics {

namespace {

bool takes(const Format& format, const Settings& settings, const Paper& paper) {
    return format.embosser == nullptr || takes_sheet(*format.embosser, settings, paper.width, paper.height) ||
           takes_sheet(*format.embosser, settings, paper.height, paper.width);
}

}  // namespace

void take_kept(Sheet& sheet, const KeptSheet& kept, const Format& format, bool paper_named, const Settings& settings) {
    const bool embossed = format.embosser != nullptr || has_fixed_dots(find_medium(format.medium, format.name));
    if (embossed) {
        const bool display = format.embosser != nullptr && format.embosser->display != nullptr;
        if (!paper_named && !display && kept.embosser_paper && takes(format, settings, *kept.embosser_paper))
            sheet.paper = *kept.embosser_paper;
        return;
    }
    if (kept.cell) sheet.cell = *kept.cell;
    if (!paper_named && kept.paper) sheet.paper = *kept.paper;
    if (sheet.medium == nullptr) sheet.medium = kept.medium;
    if (sheet.bare) return;
    if (!sheet.margin && kept.margin) {
        sheet.margin = kept.margin;
        sheet.margin_origin = kept.margin_origin;
    }
    if (!sheet.binding && kept.binding) {
        sheet.binding = kept.binding;
        sheet.binding_origin = kept.binding_origin;
    }
}

}  // namespace tactics
