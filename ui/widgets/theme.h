#pragma once

#include "ui/settings/preferences.h"
#include "ui/widgets/system_color_scheme.h"

#include <QFont>
#include <QPalette>

namespace ui
{
QPalette lightPalette();
QPalette darkPalette();

/// So many times as large.
QFont scaled(QFont font, double factor);

/// The colours of the whole application: Qt's Fusion style with our own light or dark palette, as chosen or as the
/// desktop is. A desktop that says nothing is as dark as its palette was when the program started. Thread: gui; one at
/// a time, after QApplication was made.
class Theme : public QObject
{
    Q_OBJECT

public:
    explicit Theme(ThemeChoice choice, QObject* parent = nullptr);

    void choose(ThemeChoice choice);
    bool isDark() const;

private:
    void apply();

    SystemColorScheme m_system;
    ThemeChoice m_choice;
    bool m_startedDark;
};
} // namespace ui
