#include "widgets/pairs/reason_texts.h"

#include "algorithms/messages/render.h"
#include "widgets/basics/text_ranks.h"

namespace remount::widgets {

ReasonTexts::ReasonTexts(std::shared_ptr<const pipeline::PipelineOutput> output, Language language)
    : made_(std::async(std::launch::async, [this, output, language] { return make(*output, language); })) {}

ReasonTexts::~ReasonTexts() {
  unwanted_ = true;  // what is left unmade need not be waited for
  made_.wait();
}

ReasonTexts::Made ReasonTexts::make(const pipeline::PipelineOutput& output, Language language) const {
  Made made;
  std::vector<std::string> words;
  for (const motion::Pair& pair : output.pairs) {
    if (unwanted_) return made;
    words.push_back(render(pair.reason, language));
    QString text = QString::fromStdString(words.back());
    if (language != Language::English && !text.isEmpty())
      text += QLatin1Char('\n') + QString::fromStdString(english(pair.reason));
    made.folded.push_back(text.toCaseFolded());
  }
  made.ranks = text_ranks({words.begin(), words.end()});
  for (std::size_t i = 0; i < words.size(); ++i)
    if (words[i].empty()) made.ranks[i] = -1;
  return made;
}

}  // namespace remount::widgets
