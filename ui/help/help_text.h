#pragma once

#include <QLocale>
#include <QString>

#include <span>

namespace ui
{
class Actions;

/// A page of the guide: resources/help/<language>/<id>.md, in the order of reading.
struct HelpPage
{
    const char* id;
    const char* picture = ""; ///< of a lesson, file in resources/help/pictures
    const char* command = ""; ///< id of the action that the page is about; without that action the page is left out
    bool isLesson() const { return *picture; }
};
std::span<const HelpPage> helpPages();

/// Where the pages lie in the best of the languages that there are; English else.
QString helpFolder(const QLocale& locale);

/// The page as Markdown. In its source {key:ID} is an action's key now, {menu:ID} the way to it through the menus,
/// {invert} and {smooth} what is held; an unknown one stays as it is. Empty if there is no such page.
QString helpText(const QString& id, const Actions& actions);
/// The first line, without its mark.
QString helpTitle(const QString& text);
} // namespace ui
