// SPDX-License-Identifier: Apache-2.0
// What a person keeps for the sheets of all jobs. It gives way: to what a job asks for, and where a format cannot have it.
#pragma once

#include <optional>
#include <string>

#include "print/format.h"
#include "tactics/layout/sheet.h"

namespace tactics {

struct KeptSheet {
    std::optional<Paper> paper;           ///< of pages in print and of heights
    std::optional<Paper> embosser_paper;  ///< of embossers that take it, and of files of braille
    const Medium* medium = nullptr;       ///< of pages in print and of heights; nullptr: the format's own
    std::optional<double> margin;         ///< mm, on these
    std::string margin_origin;            ///< what a message about the margin points to
    std::optional<Binding> binding;       ///< on these
    std::string binding_origin;           ///< likewise
    std::optional<CellSize> cell;         ///< of braille in print
};

/// Fills in what `sheet` leaves open. `paper_named`: its paper was asked for; else it has the format's own.
void take_kept(Sheet& sheet, const KeptSheet& kept, const Format& format, bool paper_named, const Settings& settings);

}  // namespace tactics
