// SPDX-License-Identifier: Apache-2.0
// Options that say how a model is drawn, of all commands that take one.
#pragma once

#include "cli/command.h"
#include "tactics/job/model_drawing.h"

namespace tactics {

inline constexpr Flag kModelFlag{
    "--model",
    "",
    "fold-out|views|heights",
    "how a model is drawn: folded out, without perspective and every face in its shape; or as seen from "
    "above, the front and the side, and cut through; or from above, the higher the lighter. fold-out if none is named, and "
    "heights of a terrain",
    false,
    "fold-out views heights"};
inline constexpr Flag kModelPartFlag{"--object", "", "PATH",  "of a model, only this object and what belongs to it: Table/Top",
                                     false,      "", "--part"};
inline constexpr Flag kFoldFlag{
    "--fold",
    "",
    "\"[PATH:] SETTING=VALUE...\"",
    "how a model is folded out, or one object of it: \"plane=front\", \"Table/Top: fold=no\"; the settings are "
    "in tactics help model. May be given several times",
    true,
    ""};
inline constexpr Flag kReaderFlag{
    "--reader", "",
    "FILE",     "what the reader of a folded model likes: settings of --fold, a line each, such as cost-fold = 0.1",
    false,      "files"};

/// Of all of them, those that a command does not have left out. Throws Error.
ModelDrawingWish model_wish(const Given& given);

}  // namespace tactics
