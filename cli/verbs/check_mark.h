// SPDX-License-Identifier: Apache-2.0
// The page with marks where a rule is broken.
#pragma once

#include <string>

#include "cli/verbs/check_report.h"
#include "print/format.h"

namespace tactics {

/// The page as understood, in that format, with a numbered ring at each place in text_report: red in SVG, black in other formats.
std::string mark_page(const Checked& checked, std::size_t most, const Format& format);

}  // namespace tactics
