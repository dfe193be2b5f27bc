// SPDX-License-Identifier: Apache-2.0
#include "tactics/text/decimal_comma.h"

#include <gtest/gtest.h>

namespace tactics::decimal_comma_test {
namespace {

TEST(DecimalComma, GoesByLanguageAndThenByCountry) {
    for (const char* tag : {"de", "de-AT", "DE_de", "fr", "pl-PL", "es", "es-AR", "sr-Latn-RS", "en-ZA", "pt-BR"})
        EXPECT_TRUE(writes_comma(tag)) << tag;
    for (const char* tag : {"en", "en-GB", "de-CH", "es-MX", "es-419", "ja", "ar", "he", "", "x", "de-Latn-CH", "-", "de-"})
        EXPECT_EQ(writes_comma(tag), std::string_view(tag) == "de-") << tag;
}

}  // namespace
}  // namespace tactics::decimal_comma_test
