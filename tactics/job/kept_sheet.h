// SPDX-License-Identifier: Apache-2.0
// A person's kept choices for the sheets of all jobs. A job's own wishes and the limits of a format override them.
#pragma once

#include <optional>
#include <string>

#include "print/format.h"
#include "tactics/layout/sheet.h"

namespace tactics {

struct KeptSheet {
    std::optional<Paper> paper;           ///< of printed pages and height maps
    std::optional<Paper> embosser_paper;  ///< of embossers that take it, and of braille files
    const Medium* medium = nullptr;       ///< of printed pages and height maps; nullptr: the format's own
    std::optional<double> margin;         ///< mm, on these
    std::string margin_origin;            ///< where the margin was given, for messages
    std::optional<Binding> binding;       ///< on these
    std::string binding_origin;           ///< likewise
    std::optional<CellSize> cell;         ///< of braille on printed pages
};

/// Fills in what `sheet` leaves open. `paper_named`: the job names the paper; else the sheet has the format's own.
void take_kept(Sheet& sheet, const KeptSheet& kept, const Format& format, bool paper_named, const Settings& settings);

}  // namespace tactics
