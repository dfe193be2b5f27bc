// SPDX-License-Identifier: Apache-2.0
// The page with the places marked where a rule is broken.
#pragma once

#include <string>

#include "cli/verbs/check_report.h"
#include "print/format.h"

namespace tactics {

/// The page as it was understood, in that format, with a numbered ring at each place that text_report tells: red in SVG,
/// black in all others.
std::string mark_page(const Checked& checked, std::size_t most, const Format& format);

}  // namespace tactics
