#pragma once

#include <QObject>

namespace app
{
class Document;

/// Whether a file holds the document's model as it is. Thread: gui.
class SavedState : public QObject
{
    Q_OBJECT

public:
    explicit SavedState(Document* document) : m_document(document) {}

    bool isModified() const;
    /// Changes that are not in the undo stack are in no file.
    bool isModifiedBeyondHistory() const { return m_isModifiedBeyondHistory; }
    void setModifiedBeyondHistory(bool isModified) { m_isModifiedBeyondHistory = isModified; }
    /// A file holds the model as it was at that index of the undo stack. No effect if that is not the present state.
    void setSaved(int index);
    /// The number of calls of setSaved() that had an effect.
    quint64 count() const { return m_count; }
    /// Emits modifiedChanged() if it changed and no move along the undo stack is under way.
    void emitIfChanged();

public Q_SLOTS:
    void onFileDeleted();

Q_SIGNALS:
    void modifiedChanged(bool modified);

private:
    Document* m_document;
    quint64 m_count = 0;
    bool m_isModifiedBeyondHistory = false;
    bool m_wasModified = false; ///< as it was last told
};
} // namespace app
