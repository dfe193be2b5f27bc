// SPDX-License-Identifier: Apache-2.0
// Letters drawn as shapes of which nobody knows where their line is: they stand by themselves, or in rows with raised and lowered
// ones.
#pragma once

#include <optional>
#include <vector>

#include "tactics/job/shape_set.h"
#include "tactics/readers/svg/found_page.h"

namespace tactics {

class LooseShapes {
public:
    /// Of the figure those whose file does not tell where they begin. `outlines` are of all its shapes; what is read is added to
    /// `read`.
    LooseShapes(const FoundPage& figure, const std::vector<OutlineMeasure>& outlines, LettersOfShapes& read);

    /// Whether something is not read.
    bool any() const;

    /// Whether what is not read may tell a font: it has some outlines, not only those of marks.
    bool may_tell_font() const;

    /// Units of an em in which three or more of the letters that are not read are of that font, if any.
    std::optional<double> em_in(const std::vector<FontLetter>& font) const;

    /// Reads what is a letter or figure of that font and size, wherever its line is; signs beside these, whose line is theirs;
    /// and figures of another size.
    void read_as(const std::vector<FontLetter>& font, double em);

    /// Whether letters that are not read stand beside others that are: figures of another font, as exponents and indices are.
    bool has_indices() const;
    void read_indices(const std::vector<FontLetter>& font);

private:
    void read_figure(std::size_t shape, const std::vector<FontLetter>& font);
    bool is_beside_letters(const FoundWords& words) const;
    void read_beside(const FoundWords& words, const std::vector<FontLetter>& font, double em);
    bool is_open(std::size_t shape) const;
    bool tells(std::size_t shape) const;
    std::vector<std::size_t> outlines_that_tell() const;  // one shape for each

    const FoundPage& figure_;
    const std::vector<OutlineMeasure>& outlines_;
    LettersOfShapes& read_;
    std::vector<std::size_t> own_;
};

}  // namespace tactics
