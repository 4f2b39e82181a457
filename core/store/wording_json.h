// The arguments of a sentence as JSON: a text stands as it is, a sentence within the sentence as its pattern and its
// own arguments, ["pattern", ...].
#pragma once

#include <QByteArray>
#include <QString>
#include <vector>

#include "base/sentence.h"
#include "store/journal_entry.h"

namespace tessera::store {

[[nodiscard]] QString argumentsToJson(const Sentence& sentence);
/// What nobody wrote gives no arguments.
[[nodiscard]] std::vector<Wording> argumentsFromJson(const QByteArray& json);

}  // namespace tessera::store
