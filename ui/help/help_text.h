#pragma once

#include <QLocale>
#include <QString>

#include <span>

namespace ui
{
class Actions;

/// A page of the guide, from resources/help/<language>/<id>.md.
struct HelpPage
{
    const char* id;
    const char* picture = ""; ///< picture of a lesson, a file in resources/help/pictures; empty: not a lesson
    const char* command = ""; ///< id of the action that the page is about; the page is left out while it is hidden
    bool isLesson() const { return *picture; }
};
/// Returns the pages in reading order.
std::span<const HelpPage> helpPages();

/// Returns the folder of the pages in the locale's best available language; English if none is available.
QString helpFolder(const QLocale& locale);

/// Returns the page as Markdown; empty if there is no such page. Replaces {key:ID} by the action's current shortcut,
/// {menu:ID} by its menu path, and {invert} and {smooth} by the modifier keys. Unknown placeholders stay unchanged.
QString helpText(const QString& id, const Actions& actions);
/// Returns the title, which is the first line without "# ".
QString helpTitle(const QString& text);
} // namespace ui
