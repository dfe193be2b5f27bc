// SPDX-License-Identifier: Apache-2.0
#include "cli/table_flags.h"

#include <algorithm>
#include <cmath>

#include "cli/choice_value.h"
#include "tactics/error.h"
#include "tactics/job/table_histogram.h"
#include "tactics/text/decimal_comma.h"
#include "tactics/text/number.h"

namespace tactics {

namespace {

std::optional<int> bins_of(const Given& given) {
    if (!given.has("--histogram")) return std::nullopt;
    const std::string text = given.value("--histogram");
    if (text == "auto") return 0;
    const auto bins = parse_number(text);
    if (!bins || *bins < 1 || *bins > kMostHistogramBins || *bins != std::floor(*bins))
        throw Error(Fault::usage, "--histogram",
                    phrase("it cannot be \"{0}\"; it is auto, or a number of bars from 1 to {1}", text.substr(0, 80),
                           std::to_string(kMostHistogramBins)));
    return static_cast<int>(*bins);
}

}  // namespace

TableWish table_wish(const Given& given) {
    const std::vector<std::string>& up = given.all("--y");
    TableWish wish{.x = given.value("--x"),
                   .y = up.empty() ? "" : up.front(),
                   .other_y = up.empty() ? up : std::vector<std::string>(up.begin() + 1, up.end()),
                   .z = given.value("--z"),
                   .group = given.value("--group"),
                   .points = given.has("--points"),
                   .histogram = bins_of(given),
                   .matrix = given.has("--matrix"),
                   .errors = given.all("--error"),
                   .lower = given.all("--lower"),
                   .upper = given.all("--upper"),
                   .steps = given.has("--steps"),
                   .log_x = given.has("--log-x"),
                   .log_y = given.has("--log-y")};
    if (const auto decimal = choice_value(given, "--decimal", {"point", "comma"}))
        wish.decimal = *decimal == 0 ? Decimal::point : Decimal::comma;
    constexpr BarKind kKinds[] = {BarKind::grouped, BarKind::stacked, BarKind::pie};
    if (const auto kind = choice_value(given, "--bars", {"grouped", "stacked", "pie"})) wish.bars = kKinds[*kind];
    constexpr BarWay kWays[] = {BarWay::automatic, BarWay::upright, BarWay::level};
    if (const auto way = choice_value(given, "--bar-direction", {"auto", "upright", "level"})) wish.bar_way = kWays[*way];
    if (given.has("--language")) wish.written = writes_comma(given.value("--language")) ? Decimal::comma : Decimal::point;
    constexpr DateOrder kOrders[] = {DateOrder::year_first, DateOrder::day_first, DateOrder::month_first};
    if (const auto order = choice_value(given, "--dates", {"YMD", "DMY", "MDY"})) wish.dates = kOrders[*order];
    return wish;
}

}  // namespace tactics
