#include "model/formats/bags/topic_names.h"

#include <algorithm>

namespace remount::bags {

std::vector<std::string_view> words_of(std::string_view topic) {
  std::vector<std::string_view> words;
  while (!topic.empty()) {
    const std::size_t end = std::min(topic.find_first_of("/_"), topic.size());
    if (end > 0) words.push_back(topic.substr(0, end));
    topic.remove_prefix(std::min(end + 1, topic.size()));
  }
  return words;
}

std::size_t words_alike(std::string_view topic, std::string_view other) {
  const std::vector<std::string_view> own = words_of(topic), its = words_of(other);
  return static_cast<std::size_t>(std::ranges::mismatch(own, its).in1 - own.begin());
}

bool of_one_device(std::string_view topic, std::string_view other) {
  const std::string_view device = topic.substr(0, topic.rfind('/') + 1);
  return device.size() > 1 && other.starts_with(device);
}

}  // namespace remount::bags
