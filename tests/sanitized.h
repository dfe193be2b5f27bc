// SPDX-License-Identifier: Apache-2.0
// Whether the tests are built with a sanitizer that has an allocator and ways of its own.
#pragma once

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define TACTICS_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define TACTICS_SANITIZED 1
#endif
#endif
#ifndef TACTICS_SANITIZED
#define TACTICS_SANITIZED 0
#endif
