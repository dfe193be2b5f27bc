// SPDX-License-Identifier: Apache-2.0
// Tests of what the contour net draws, where its weights may have been left out: they are a file and a package of their own.
#pragma once

#include <gtest/gtest.h>

#include "filters/net/nets.h"

#define SKIP_WITHOUT_WEIGHTS() \
    if (tactics::find_net() == nullptr) GTEST_SKIP() << "the weights of the contour net are not installed"
