#pragma once

#include <QString>

#include <functional>

namespace core
{
struct JobControl;
}

namespace app
{
class Document;
struct ModelHistory;

/// Sees the states of the model, from the first that is kept to the present. Thread: another. Cancelling the document's
/// job reaches it.
using Visit = std::function<void(const ModelHistory& history, const core::JobControl& control)>;

/// Goes through the document's history on a copy; `done` is called afterwards. Nobody sculpts meanwhile, and the model
/// stays as it is. Returns false if another job goes on: then nothing is done. Thread: gui.
bool visitHistory(Document& document, const QString& what, Visit visit, std::function<void()> done);
} // namespace app
