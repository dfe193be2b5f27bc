// SPDX-License-Identifier: Apache-2.0
// The machines, each as far as its protocol is known. Their input may come from anywhere and is never trusted.
#pragma once

#include "print/machines/punched.h"
#include "tactics/option.h"

namespace tactics {

Punched punch_generic(std::string_view bytes, const Settings& settings);
Punched punch_index_v3(std::string_view bytes, const Settings& settings);
Punched punch_index_v4(std::string_view bytes, const Settings& settings);
Punched punch_index_floating(std::string_view bytes, const Settings& settings);
Punched punch_viewplus(std::string_view bytes, const Settings& settings);
Punched punch_enabling(std::string_view bytes, const Settings& settings);
Punched punch_braillo(std::string_view bytes, const Settings& settings);
Punched punch_cidat(std::string_view bytes, const Settings& settings);
Punched punch_mountbatten(std::string_view bytes, const Settings& settings);
Punched punch_nippon(std::string_view bytes, const Settings& settings);
Punched punch_dot_pad(std::string_view bytes, const Settings& settings);
Punched punch_graphiti(std::string_view bytes, const Settings& settings);

}  // namespace tactics
