#pragma once

#include <QDialog>

class QLabel;
class QPushButton;

namespace ui
{
/// Says before a class ends how many works are still on this computer, and offers to copy them. Accepted, and rejected:
/// the class ends. Thread: gui.
class WaitingWorksDialog : public QDialog
{
    Q_OBJECT

public:
    /// `problem`: why they are, one sentence. `folder`: where they are. Deletes itself when it closes.
    WaitingWorksDialog(int works, const QString& problem, const QString& folder, QWidget* parent);

    /// Says what came of the copying.
    void showCopied(const QString& sentence);

Q_SIGNALS:
    void copyRequested(const QString& folder);

private:
    void chooseFolder();

    QLabel* m_word;
    QPushButton* m_copy;
};
} // namespace ui
