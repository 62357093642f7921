#pragma once

#include "preferences.h"

#include <QDialog>

#include <functional>
#include <vector>

class QFormLayout;

namespace ui
{
/// The preferences on pages; each change holds at once. Deletes itself when closed. Gui thread.
class PreferencesDialog : public QDialog
{
    Q_OBJECT

public:
    PreferencesDialog(const Preferences& now, QWidget* parent);

    const Preferences& preferences() const { return m_now; }

Q_SIGNALS:
    void changed(const ui::Preferences& preferences);

private:
    struct Words
    {
        const char* name; ///< of the control
        QString label, tip;
    };

    QWidget* appearancePage();
    QWidget* inputPage();
    QWidget* buttonRow();
    template <class T, std::size_t count>
    void addChoice(QFormLayout* form, const Words& words, const std::array<Named<T>, count>& choices, T Preferences::*what);
    void addCheck(QFormLayout* form, const Words& words, bool HandHabits::*what);
    static QString words(ThemeChoice theme);
    static QString words(Language language);
    void change(const Preferences& to);

    Preferences m_now;
    std::vector<std::function<void()>> m_show; ///< what brings each control to m_now
};
} // namespace ui
