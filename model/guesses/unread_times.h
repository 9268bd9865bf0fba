// Why no column of a table is read as its time.
#pragma once

#include <vector>

#include "algorithms/messages/message.h"
#include "model/guesses/named_columns.h"

namespace remount::guesses {

/// Of the columns that are called times, or look like them, each with what is expected; at least one message.
std::vector<Message> why_no_time(const SampledTable& table, const ColumnNames& names);

/// Whether a column is called a time, or looks like one, and is not read.
bool has_unread_time(const SampledTable& table, const ColumnNames& names);

}  // namespace remount::guesses
