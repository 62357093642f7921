#pragma once

#include <QDialog>

class QLabel;
class QPushButton;

namespace ui
{
/// Tells the teacher, before a class ends, how many works are still on this computer only, and offers to copy them. The
/// class ends however the dialog is closed. Thread: gui.
class WaitingWorksDialog : public QDialog
{
    Q_OBJECT

public:
    /// `problem`: why the works are not in the class's folder, one sentence. `folder`: their folder on this computer.
    /// The dialog deletes itself when it closes.
    WaitingWorksDialog(int works, const QString& problem, const QString& folder, QWidget* parent);

    /// Shows the result of the copying.
    void showCopied(const QString& sentence);

Q_SIGNALS:
    void copyRequested(const QString& folder);

private:
    void chooseFolder();

    QLabel* m_word;
    QPushButton* m_copy;
};
} // namespace ui
