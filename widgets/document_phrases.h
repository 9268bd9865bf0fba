// What is said of documents (session.yaml, settings, results, projects), and of reading and saving files as such: a
// part of model_phrases().
#pragma once

#include <vector>

namespace remount {

const std::vector<const char*>& document_phrases();

}  // namespace remount
