#pragma once

#include "ui/actions/shortcut_map.h"

#include <QWidget>

#include <array>

class QComboBox;
class QLabel;
class QLayout;
class QLineEdit;
class QPushButton;

namespace ui
{
class Actions;
class CommandList;
class KeyEdit;

/// Of the preferences: every command with its keys, which are changed where they stand; a key that is taken or needed
/// otherwise is refused with the reason. Gui thread.
class KeysPage : public QWidget
{
    Q_OBJECT

public:
    /// The actions must outlive it.
    explicit KeysPage(const Actions& actions, QWidget* parent = nullptr);

    void setChoice(const KeyChoice& choice);

Q_SIGNALS:
    void changed(const ui::KeyChoice& choice);

private:
    QLayout* presetRow();
    QLayout* editRow();
    QLayout* wordRow();
    void showCurrent();
    void enter(std::size_t place, const QKeySequence& key);
    void reset();
    void change(const KeyChoice& choice);
    QString refusal(const QKeySequence& key) const;
    void say(const QString& sentence, const QString& owner = {});
    void goToOwner();
    QString currentId() const;
    QString nameOf(const QString& id) const;

    const Actions& m_actions;
    KeyChoice m_choice;
    KeyMap m_keys;
    QString m_owner; ///< of the key that was refused

    QComboBox* m_preset;
    QLabel* m_held;
    QLineEdit* m_words;
    CommandList* m_list;
    QLabel* m_name;
    std::array<KeyEdit*, mostKeys> m_edits;
    QPushButton* m_reset;
    QPushButton* m_resetAll;
    QLabel* m_word;
    QPushButton* m_goThere;
};
} // namespace ui
