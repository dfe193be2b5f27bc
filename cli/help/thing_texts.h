// SPDX-License-Identifier: Apache-2.0
// The help text of one entry of a list, below its line with name and summary.
#pragma once

#include <string>
#include <string_view>

#include "cli/command.h"
#include "filters/list.h"
#include "print/embosser.h"
#include "print/format.h"
#include "tactics/braille/tables.h"
#include "tactics/medium.h"
#include "tactics/rules/rule.h"

namespace tactics {

std::string describe_filter(const Filter& filter);
std::string describe_recipe(const NamedRecipe& recipe);
std::string describe_format(const Format& format);
std::string describe_embosser(const Format& format);  ///< also for a display
std::string describe_braille_table(const BrailleTable& table);
std::string describe_medium(const Medium& medium);
std::string describe_paper(const Paper& paper);
std::string describe_rule(const Rule& rule);
std::string describe_cell(const NamedCell& cell);

std::string explain_command(const Command& command);

/// "-o, --output OUT"
std::string spelling(const Flag& flag);
/// "blur=LENGTH" or "method=NAME"
std::string spelling(const Option& option);

std::string indent(std::string_view text);  ///< indents every line by two blanks

}  // namespace tactics
