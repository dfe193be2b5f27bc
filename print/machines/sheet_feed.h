// SPDX-License-Identifier: Apache-2.0
// The mechanism that all machines share: a sheet, and lines of cells on it.
#pragma once

#include <optional>

#include "print/machines/punched.h"

namespace tactics {

/// A machine that sets cells, line by line.
struct CellHead {
    Point first;       ///< of dot 1 of the first cell
    double dot = 2.5;  ///< mm from dot to dot
    double cell = 6;   ///< from cell to cell
    double line = 10;  ///< from line to line
};

class SheetFeed {
public:
    explicit SheetFeed(CellHead head) : head_(head) {}

    CellHead& head() { return head_; }
    void at(std::size_t byte) { at_ = byte; }   ///< sets the position of the byte being read
    void begin();                               ///< begins the sheet here, if nothing began it before
    void set_up(std::size_t end);               ///< from the byte being read up to that one
    void set_cell(std::uint8_t cell);           ///< and moves one cell to the right
    void set_dot(Point at, double height = 1);  ///< its height as a share of the full one
    void set_apart(std::vector<std::uint8_t> cells) { sheet_.apart = std::move(cells); }
    void carriage_return() { column_ = 0; }
    void line_feed();
    void form_feed(std::size_t end);
    void end_job(std::size_t end);                    ///< the byte before that one ends a job and belongs to its last sheet
    void note(std::size_t byte, const Phrase& text);  ///< keeps the first few, then a note that there are more

    /// Ejects a sheet that is still in the machine if anything is on it.
    Punched finish(std::size_t end);

private:
    CellHead head_;
    std::size_t at_ = 0;
    bool began_ = false;
    std::size_t set_up_begin_ = 0, set_up_end_ = 0, dots_ = 0;
    std::size_t column_ = 0, line_ = 0;
    PunchedSheet sheet_;
    Punched punched_;
    std::size_t notes_ = 0;
};

/// The cell of a letter of North American Braille Computer Code; lower case counts as upper case. Nothing: no such letter.
std::optional<std::uint8_t> cell_of_letter(unsigned char letter);

}  // namespace tactics
