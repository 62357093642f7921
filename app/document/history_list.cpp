#include "app/document/history_list.h"

#include "app/document/document.h"
#include "app/document/stroke_command.h"

namespace app
{
ui::History historyOf(Document& document)
{
    const QUndoStack& stack = document.history().stack();
    const HistoryStore& store = document.history().store();
    ui::History history;
    history.steps.reserve(stack.count());
    for (int i = 0; i < stack.count(); ++i) {
        const auto* command = static_cast<const StrokeCommand*>(stack.command(i)); // only StrokeCommands are pushed
        history.steps.append({command->text(), command->marks().icon, command->marks().dabs, command->marks().fusions});
    }
    history.present = stack.index();
    history.first = store.firstIndex();
    history.last = store.lastIndex();
    history.bytes = static_cast<qint64>(store.bytesInMemory());
    return history;
}
} // namespace app
