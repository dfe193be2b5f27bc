// SPDX-License-Identifier: Apache-2.0
// Options for drawing models, shared by all commands that take one.
#pragma once

#include "cli/command.h"
#include "tactics/job/model_drawing.h"

namespace tactics {

inline constexpr Flag kModelFlag{
    "--model",
    "",
    "fold-out|views|heights",
    "how a model is drawn: folded out, without perspective and with every face in its true shape (fold-out); as seen from "
    "above, the front and the side, and cut through (views); or from above, the higher the lighter (heights). Default: "
    "fold-out, but heights for a terrain",
    false,
    "fold-out views heights"};
inline constexpr Flag kModelPartFlag{"--object", "", "PATH",  "draw only this object of a model and its parts: Table/Top",
                                     false,      "", "--part"};
inline constexpr Flag kFoldFlag{
    "--fold",
    "",
    "\"[PATH:] SETTING=VALUE...\"",
    "how a model, or one object of it, is folded out: \"plane=front\", \"Table/Top: fold=no\"; tactics help model lists the "
    "settings. May be given several times",
    true,
    ""};
inline constexpr Flag kReaderFlag{
    "--reader",
    "",
    "FILE",
    "file with the preferences of the person who reads a folded model: settings of --fold, one per line, such as "
    "cost-fold = 0.1",
    false,
    "files"};

/// The wishes from all of them; options that a command does not have are ignored. Throws Error.
ModelDrawingWish model_wish(const Given& given);

}  // namespace tactics
