// What the model says, which knows no windows, in the language of the window.
#pragma once

#include <QString>

#include "algorithms/messages/render.h"

namespace remount::widgets {

/// The message in the present language. Options and flags that it mentions are named as in the window; what a user
/// typed stays as it is.
QString model_text(const Message& message);
Language window_language();

/// In whatever language it is: options that it mentions by their keys have the names that their pages give them, and
/// flags of the command line are the places of the window for what they give.
QString in_words_of_window(const QString& text);

}  // namespace remount::widgets
