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

/// A callback that receives the stored states of the model. It runs on a background thread. Cancelling the document's
/// job cancels it.
using Visit = std::function<void(const ModelHistory& history, const core::JobControl& control)>;

/// Runs `visit` on a copy of the document's history, then calls `done`. Sculpting is paused meanwhile, and the model
/// does not change. Returns false and does nothing if another job is running. Thread: gui.
bool visitHistory(Document& document, const QString& what, Visit visit, std::function<void()> done);
} // namespace app
