#pragma once

#include <QObject>

#include <optional>

namespace app
{
class Document;

/// Moves the document to the latest requested state, a few steps at a time. A drag that changes direction thus does not
/// wait for steps that are no longer wanted. Thread: gui.
class HistoryScrubber : public QObject
{
    Q_OBJECT

public:
    /// A child of the document.
    explicit HistoryScrubber(Document* document);

    /// Moves to the undo state `state`, or to the nearest state that is still stored.
    void scrubTo(int state);

private:
    void proceed();

    Document* m_document;
    std::optional<int> m_target;
    int m_from = 0; ///< expected undo index after the moves requested so far
};
} // namespace app
