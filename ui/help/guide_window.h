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

/// The user guide: contents and search at the left, the page at the right. Words that are sought leave only the pages
/// that have them, and are marked; Return goes on to the next place. Pages about commands that are hidden, as in a
/// class, are left out. Stays open beside the main window. Thread: gui.
class GuideWindow : public QDialog
{
    Q_OBJECT

public:
    /// The actions must outlive it.
    explicit GuideWindow(const Actions& actions, QWidget* parent);

    /// By its id; the first if there is no such page. As the keys are now.
    void openPage(const QString& page);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void fillContents();
    void followLink(const QUrl& url);
    int rowOf(const QString& page) const; ///< in the contents; -1: it is not there
    void showPage();
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
