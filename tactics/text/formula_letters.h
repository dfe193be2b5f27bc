// SPDX-License-Identifier: Apache-2.0
// Letters of formulas, which have codes of their own for each look (Unicode, Mathematical Alphanumeric Symbols).
#pragma once

namespace tactics {

/// The italic letter; the same for what formulas do not slant: all but Latin and small Greek letters.
char32_t slanted(char32_t code);

/// The letter of any look: x for an italic one, and of Greek letters the common form: \u03c6 for the \u03d5 of formulas. Any
/// other code is the same.
char32_t plain_code(char32_t code);

}  // namespace tactics
