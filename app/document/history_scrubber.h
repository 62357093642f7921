#pragma once

#include <QObject>

#include <optional>

namespace app
{
class Document;

/// Takes the document to the state that was wanted last, by a few steps at a time, so that one who drags and turns back
/// does not wait for what is not wanted any more. Gui thread.
class HistoryScrubber : public QObject
{
    Q_OBJECT

public:
    /// A child of the document.
    explicit HistoryScrubber(Document* document);

    /// A state of the undo stack; the nearest that is kept is gone to.
    void want(int state);

private:
    void goOn();

    Document* m_document;
    std::optional<int> m_wanted;
    int m_from = 0; ///< where the last steps lead
};
} // namespace app
