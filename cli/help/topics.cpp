// SPDX-License-Identifier: Apache-2.0
#include "cli/help/topics.h"

namespace tactics {

extern const Topic mouse_topic;
extern const Topic arms_topic;
extern const Topic model_topic;
extern const Topic felt_topic;
extern const Topic json_topic;

std::span<const Topic> topics() {
    static const Topic kTopics[] = {mouse_topic, arms_topic, model_topic, felt_topic, json_topic};
    return kTopics;
}

const Topic* find_topic(std::string_view name) {
    for (const Topic& topic : topics())
        if (topic.name == name) return &topic;
    return nullptr;
}

}  // namespace tactics
