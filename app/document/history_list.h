#pragma once

#include "ui/history/history_panel.h"

namespace app
{
class Document;

/// The document's undo stack as the panel shows it. Cost: its steps.
ui::History historyOf(Document& document);
} // namespace app
