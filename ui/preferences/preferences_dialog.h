#pragma once

#include "ui/settings/preferences.h"

#include <QDialog>

#include <functional>
#include <vector>

class QFormLayout;

namespace ui
{
class Actions;

/// The pages of preferences. Each change takes effect at once. The dialog deletes itself when closed. Thread: gui.
class PreferencesDialog : public QDialog
{
    Q_OBJECT

public:
    /// Precondition: `actions` outlives the dialog.
    PreferencesDialog(const Preferences& now, const Actions& actions, QWidget* parent);

    const Preferences& preferences() const { return m_now; }
    /// Shows preferences that were changed outside the dialog.
    void setPreferences(const Preferences& preferences);

    static QString words(Language language);

Q_SIGNALS:
    void changed(const ui::Preferences& preferences);
    /// All settings of the program are to be reset; the receiver must then call setPreferences().
    void resetRequested();

private:
    struct ControlText
    {
        const char* name; ///< objectName of the control
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
    std::vector<std::function<void()>> m_show; ///< functions that set each control to its value in m_now
};
} // namespace ui
