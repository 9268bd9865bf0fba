// What the model says of the topics of a bag (widgets/model_text.h).
#pragma once

#include <vector>

namespace remount {

const std::vector<const char*>& topic_phrases();

}  // namespace remount
