#include "app/gui/jobs/error_words.h"

#include <QCoreApplication>
#include <new>

#include "algorithms/messages/catalogue.h"
#include "widgets/text/model_text.h"

namespace remount::gui {
namespace {

struct ErrorText {
  Q_DECLARE_TR_FUNCTIONS(remount::gui::error_words)
};

/// Nothing where the error says it itself; what the system says of a disk never does.
QString what_to_try(const Error& error) {
  if (error.code() != ErrorCode::Io && advises(error.what_happened())) return {};
  switch (error.code()) {
    case ErrorCode::Io:
      return ErrorText::tr("Is the disk connected, is there room on it, and may you read and write there?");
    case ErrorCode::Format:
      return ErrorText::tr(
          "Was the recording cut off, or the file edited? Copy it from its source again, or leave it out.");
    case ErrorCode::Unsupported:
      return ErrorText::tr("F1 in the empty window lists what can be opened.");
    case ErrorCode::Contract:
      break;  // says what has to be otherwise
  }
  return {};
}

}  // namespace

JobFailure failure_of(const Error& error) {
  QString text = widgets::model_text(error.what_happened());
  if (const QString advice = what_to_try(error); !advice.isEmpty()) text += QLatin1Char('\n') + advice;
  return {QString::fromStdString(error.where()), text};
}

JobFailure failure_of(const std::exception& error) {
  if (const auto* known = dynamic_cast<const Error*>(&error)) return failure_of(*known);
  if (dynamic_cast<const std::bad_alloc*>(&error))
    return {{}, JobRunner::tr("There is not enough memory. Lower cache_mb in the options, or use fewer keyframes.")};
  return {{}, JobRunner::tr("Unexpected failure: %1. What was there is kept.").arg(QString::fromUtf8(error.what()))};
}

QString in_words(const JobFailure& failure) {
  return failure.where.isEmpty() ? failure.what : failure.where + QStringLiteral(": ") + failure.what;
}

}  // namespace remount::gui
