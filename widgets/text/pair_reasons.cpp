#include "widgets/text/pair_reasons.h"

#include "messages/decisions.h"
#include "widgets/text/model_text.h"

namespace remount::widgets {

const std::vector<Message (*)()>& quick_reasons() {
  static const std::vector<Message (*)()> reasons{say::reason_moving_objects, say::reason_aligned_wrongly,
                                                  say::reason_too_little_in_common, say::reason_ins_doubtful,
                                                  say::reason_view_blocked};
  return reasons;
}

bool tells_who_only(const Message& reason) {
  return reason == say::accepted_by_the_user() || reason == say::rejected_by_the_user();
}

QString reason_words(const Message& reason) { return QString::fromStdString(render(reason, window_language())); }

}  // namespace remount::widgets
