#pragma once

#include <QStringList>
#include <QWidget>

class QLabel;
class QPlainTextEdit;

namespace ui
{
/// The names of a class's pupils, a line for each. A sentence below says what of them is not taken as it was typed.
/// Thread: gui.
class NamesField : public QWidget
{
    Q_OBJECT

public:
    NamesField();

    void setNames(const QStringList& names);
    /// Returns the names as a class's file keeps them: each once, without what ends a name there.
    QStringList names() const;
    /// Returns why a class cannot have these names, one sentence; empty: it can.
    QString fault() const;

private:
    QStringList repeated() const;
    void showWord();

    QPlainTextEdit* m_text;
    QLabel* m_word;
};
} // namespace ui
