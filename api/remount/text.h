// What Remount says, as a value: words are made of it in the language of whoever reads them.
#pragma once

#include <memory>
#include <string>

namespace remount {
class Message;
}  // namespace remount

namespace remount::api {

enum class Language { English, Chinese };

class Text {
 public:
  Text() = default;  ///< says nothing
  /// Words of yours: the same in every language.
  Text(std::string words);  // NOLINT: words are a text
  Text(const char* words);  // NOLINT
  explicit Text(const Message& message);

  bool empty() const;
  std::string in(Language language) const;
  std::string english() const { return in(Language::English); }
  /// Which sentence it is, by a name that stays; empty for words of yours.
  std::string code() const;
  /// What it is made of, for Remount itself.
  const Message& message() const;

 private:
  std::shared_ptr<const Message> message_;
};

}  // namespace remount::api
