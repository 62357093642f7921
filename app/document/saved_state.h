#pragma once

#include <QObject>

namespace app
{
class Document;

/// Tracks whether a file contains the document's present model. Thread: gui.
class SavedState : public QObject
{
    Q_OBJECT

public:
    explicit SavedState(Document* document) : m_document(document) {}

    bool isModified() const;
    /// Returns whether there are unsaved changes that are not in the undo stack.
    bool isModifiedBeyondHistory() const { return m_isModifiedBeyondHistory; }
    void setModifiedBeyondHistory(bool isModified) { m_isModifiedBeyondHistory = isModified; }
    /// Records that a file contains undo state `index`. Has no effect if that is not the present state.
    void setSaved(int index);
    /// Returns the number of calls of setSaved() that had an effect.
    quint64 count() const { return m_count; }
    /// Emits modifiedChanged() if the value has changed, except during a move along the undo stack.
    void emitIfChanged();

public Q_SLOTS:
    void onFileDeleted();

Q_SIGNALS:
    void modifiedChanged(bool modified);

private:
    Document* m_document;
    quint64 m_count = 0;
    bool m_isModifiedBeyondHistory = false;
    bool m_wasModified = false; ///< value of the last modifiedChanged()
};
} // namespace app
