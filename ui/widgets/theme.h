#pragma once

#include "ui/settings/preferences.h"
#include "ui/widgets/system_color_scheme.h"

#include <QFont>
#include <QPalette>

namespace ui
{
QPalette lightPalette();
QPalette darkPalette();

/// Returns the font with its size multiplied by `factor`.
QFont scaled(QFont font, double factor);

/// Colours of the whole application: AppStyle with a light or dark palette, by the user's choice or the desktop's
/// colour scheme. If the scheme is unknown, the palette at program start decides. Thread: gui. Precondition:
/// QApplication exists, and there is no other Theme.
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
