// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/job_end.h"

namespace tactics {

namespace {

// A user who cancels a job does not want to wait as long as for a page.
constexpr std::chrono::seconds kPatienceWithDevice{5};

}  // namespace

Phrase end_job(Channel& channel, std::string_view end, const std::function<bool()>& given_up) {
    using Cancel = DeliveryWish::Cancel;
    DeliveryWish wish;
    wish.patience = kPatienceWithDevice;
    wish.cancel = [&] { return given_up() ? Cancel::at_once : Cancel::no; };
    if (deliver(channel, end, wish).ending == Ending::done) return {};
    return phrase(
        "what ends a job did not go to the machine, which may wait for the rest of this one; switch it off and on "
        "before the next");
}

}  // namespace tactics
