// Sentences that follow each other.
#pragma once

#include <QStringList>

namespace remount::widgets {

/// One text of several sentences: with a space between them, but for after "。" and its like, which hold one.
QString one_text(const QStringList& sentences);

}  // namespace remount::widgets
