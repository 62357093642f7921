#pragma once

#include <QObject>

#include <functional>

namespace app
{
class Document;

/// Opens models one after the other, and knows which one came. Thread: gui.
class OpeningQueue : public QObject
{
    Q_OBJECT

public:
    explicit OpeningQueue(Document* document);

    /// Calls `open`, which has the document open a model, and `then` when that model is there.
    void openThen(const std::function<void()>& open, const std::function<void()>& then);

Q_SIGNALS:
    /// The model could not be opened, which the window has said, or the user cancelled it.
    void failed();

private:
    void proceed();
    void checkIdle();

    Document* m_document;
    std::function<void()> m_then; ///< for the model that is being opened
    bool m_isOpened = false;      ///< that model is there, and goOn() comes next
};
} // namespace app
