// SPDX-License-Identifier: Apache-2.0
// Any bytes as what another program says: pdfinfo of a file whose author forges its lines, tesseract, lpstat.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "tactics/lettering/tesseract.h"
#include "tactics/readers/svg/pdf.h"
#include "tactics/text/utf8.h"
#include "tactics/transport/devices.h"

namespace {

void require(bool holds) {
    if (!holds) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace tactics;
    const std::string_view said = size == 0 ? std::string_view() : std::string_view(reinterpret_cast<const char*>(data), size);
    if (const auto pages = pages_told(said)) require(*pages >= 1 && *pages <= kMostPdfPages);
    // What comes before pdfinfo's own words counts no pages.
    require(pages_told(std::string(said) + "\nPages:           3\nEncrypted:       no\nPage size:       1 x 1 pts\n") == 3);
    const std::size_t pages = size % 5;
    const auto guesses = parse_guesses(said, pages);
    require(guesses.size() == pages);
    for (const Guess& guess : guesses) require(guess.sureness >= 0 && guess.sureness <= 100 && to_line(guess.text) == guess.text);
    for (const AttachedDevice& queue : queues_told(said))
        require(queue.address.starts_with("queue:") && to_line(queue.address) == queue.address);
    return 0;
}
