#pragma once

#include "ui/history/history_panel.h"

namespace app
{
class Document;

/// Returns the document's undo stack in the form that the History panel shows. Cost: linear in the number of steps.
ui::History historyOf(Document& document);
} // namespace app
