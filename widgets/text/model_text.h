// Sentences of the model, which knows no languages, in the language of the window.
#pragma once

#include <QString>
#include <string>
#include <string_view>
#include <vector>

#include "algorithms/messages/render.h"

namespace remount {

/// The sentence in the present language: recognised as one of model_phrases(), whose "%1" stand for whatever the model
/// put there. What is not recognised stays English: better understood than lost. Options and flags that it mentions are
/// named as in the window.
QString model_text(std::string_view text);
QString model_text(const std::string& text);
QString model_text(const QString& text);
QString model_text(const Message& message);
Language window_language();

/// In whatever language it is: options that it mentions by their keys have the names that their pages give them, and
/// flags of the command line are the places of the window for what they give.
QString in_words_of_window(const QString& text);

/// What the model says, as patterns. A new sentence of the model that users see often gets a line here.
const std::vector<const char*>& model_phrases();

}  // namespace remount
