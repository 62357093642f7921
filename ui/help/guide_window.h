#pragma once

#include <QDialog>

class QLabel;
class QLineEdit;
class QListWidget;
class QTextBrowser;
class QUrl;

namespace ui
{
class Actions;

/// The user guide: contents and search field at the left, page at the right. A search shows only the pages that contain
/// all its words, and highlights the first word; Return finds the next occurrence. Stays open beside the main window.
/// Thread: gui.
class GuideWindow : public QDialog
{
    Q_OBJECT

public:
    /// Precondition: `actions` outlives the window.
    explicit GuideWindow(const Actions& actions, QWidget* parent);

    /// Shows the page with this id, or the first page if there is none. The page names the current shortcuts.
    void openPage(const QString& page);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void fillContents();
    void followLink(const QUrl& url);
    int rowOf(const QString& page) const; ///< row of the page in the contents; -1: not listed
    void showPage();
    void removeDeadLinks();
    void search();
    void findNext();
    void markFound();

    const Actions& m_actions;
    QLineEdit* m_words;
    QListWidget* m_contents;
    QTextBrowser* m_text;
    QLabel* m_nothing;
};
} // namespace ui
