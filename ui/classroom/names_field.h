#pragma once

#include <QStringList>
#include <QWidget>

class QLabel;
class QPlainTextEdit;

namespace ui
{
/// An editor for the names of a class's pupils, one on each line. A remark below reports names that are repeated or not
/// acceptable. Thread: gui.
class NamesField : public QWidget
{
    Q_OBJECT

public:
    NamesField();

    void setNames(const QStringList& names);
    /// Returns the names as a class file stores them: without duplicates and without the separator ";".
    QStringList names() const;
    /// Returns why these names are not acceptable, one sentence; empty: acceptable.
    QString fault() const;

private:
    QStringList repeated() const;
    void showWord();

    QPlainTextEdit* m_text;
    QLabel* m_word;
};
} // namespace ui
