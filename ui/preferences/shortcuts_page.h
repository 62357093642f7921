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
class ShortcutEdit;

/// The page of shortcuts: a list of all commands with their keys, which are edited in place. A key that is taken or
/// reserved is refused with the reason. Thread: gui.
class ShortcutsPage : public QWidget
{
    Q_OBJECT

public:
    /// Precondition: `actions` outlives the page.
    explicit ShortcutsPage(const Actions& actions, QWidget* parent = nullptr);

    void setShortcuts(const ShortcutSettings& shortcuts);

Q_SIGNALS:
    void changed(const ui::ShortcutSettings& shortcuts);

private:
    QLayout* presetRow();
    QLayout* editRow();
    QLayout* messageRow();
    void showCurrent();
    void enter(std::size_t place, const QKeySequence& key);
    void reset();
    void change(const ShortcutSettings& shortcuts);
    QString refusal(const QKeySequence& key) const;
    void showMessage(const QString& sentence, const QString& owner = {});
    void goToOwner();
    QString currentId() const;
    QString nameOf(const QString& id) const;

    const Actions& m_actions;
    ShortcutSettings m_shortcuts;
    ShortcutMap m_keys;
    QString m_owner; ///< id of the action that has the refused key

    QComboBox* m_preset;
    QLabel* m_modifierHelp;
    QLineEdit* m_words;
    CommandList* m_list;
    QLabel* m_name;
    std::array<ShortcutEdit*, maxKeys> m_edits;
    QPushButton* m_reset;
    QPushButton* m_resetAll;
    QLabel* m_word;
    QPushButton* m_goThere;
};
} // namespace ui
