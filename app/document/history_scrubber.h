#pragma once

#include <QObject>

#include <optional>

namespace app
{
class Document;

/// Takes the document to the state that was requested last, a few steps at a time, so that a drag that turns back does
/// not wait for steps that are no longer requested. Thread: gui.
class HistoryScrubber : public QObject
{
    Q_OBJECT

public:
    /// A child of the document.
    explicit HistoryScrubber(Document* document);

    /// Goes to that state of the undo stack, or to the nearest one that is kept.
    void scrubTo(int state);

private:
    void proceed();

    Document* m_document;
    std::optional<int> m_target;
    int m_from = 0; ///< where the last steps lead
};
} // namespace app
