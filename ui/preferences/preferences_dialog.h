#pragma once

#include "ui/settings/preferences.h"

#include <QDialog>

#include <functional>
#include <vector>

class QFormLayout;

namespace ui
{
class Actions;

/// The preferences on pages; each change holds at once. Deletes itself when closed. Thread: gui.
class PreferencesDialog : public QDialog
{
    Q_OBJECT

public:
    /// The actions must outlive it.
    PreferencesDialog(const Preferences& now, const Actions& actions, QWidget* parent);

    const Preferences& preferences() const { return m_now; }
    /// Another hand chose.
    void setPreferences(const Preferences& preferences);

    static QString words(Language language);

Q_SIGNALS:
    void changed(const ui::Preferences& preferences);
    /// Everything in the program is to be as at first; the dialog is to be shown what that is.
    void resetRequested();

private:
    struct ControlText
    {
        const char* name; ///< of the control
        QString label, tip;
    };

    QWidget* appearancePage();
    QWidget* inputPage();
    QWidget* filesPage();
    QWidget* keysPage(const Actions& actions);
    QWidget* buttonRow();
    void askToReset();
    template <class T, std::size_t count>
    void addChoice(QFormLayout* form, const ControlText& words, const std::array<Named<T>, count>& choices,
                   T Preferences::*what);
    template <class Part> void addCheck(QFormLayout* form, const ControlText& words, Part part);
    void addPen(QFormLayout* form);
    static QString words(ThemeChoice theme);
    static QString words(TextSize size);
    void change(const Preferences& to);

    Preferences m_now;
    std::vector<std::function<void()>> m_show; ///< what brings each control to m_now
};
} // namespace ui
