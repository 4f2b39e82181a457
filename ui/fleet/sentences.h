// The one place where ui/fleet turns the supervisor's sentences into what people read.
#pragma once

#include <QString>
#include <string>

#include "supervisor/event.h"
#if __has_include("ui/base/wording.h")
#include "ui/base/wording.h"
#endif

namespace tessera::ui {

using EventSentence = decltype(supervisor::Event::sentence);

[[nodiscard]] inline QString said(const std::string& sentence) { return QString::fromStdString(sentence); }
#if __has_include("ui/base/wording.h")
[[nodiscard]] inline QString said(const EventSentence& sentence) { return text(sentence); }
#endif

}  // namespace tessera::ui
