// SPDX-License-Identifier: Apache-2.0
// What a person is told of a text or a table that cannot be set.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "tactics/braille/braille.h"
#include "tactics/error.h"

namespace tactics::tests {

inline std::string message_of(std::string_view text, std::string_view table) {
    try {
        to_braille(text, table);
    } catch (const Error& error) {
        EXPECT_EQ(error.fault(), Fault::usage);
        return error.what();
    }
    return "no error";
}

}  // namespace tactics::tests
