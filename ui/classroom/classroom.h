#pragma once

#include "ui/settings/preferences.h"

#include "core/primitives/starter_models.h"
#include "core/stroke/tool.h"

#include <QList>
#include <QString>
#include <QStringList>

namespace ui
{
inline constexpr int maxTurnMinutes = 240;
inline constexpr int maxPupilNames = 200, maxPupilNameLength = 40; ///< number of names; characters of a name
inline constexpr int minPinLength = 4, maxPinLength = 32;          ///< characters

/// A teacher's choices for a class.
struct Classroom
{
    QString title;
    QString folder; ///< absolute path of the folder for the pupils' works
    /// No duplicates; not empty unless there is a lesson; the first is opened before pupils choose.
    QList<core::Starter> starters;
    QList<core::Tool> tools; ///< no duplicates, not empty; a turn begins with the first tool
    int turnMinutes = 20;    ///< 0: a turn has no end
    int warningMinutes = 3;  ///< minutes before the end of a turn; 0: no warning
    bool fullScreen = true;
    Language language = Language::System;
    QString pin = {};           ///< hash written by app/class_pin, never the digits themselves
    bool asksQuestions = false; ///< six questions about the program after each turn
    QStringList names = {};     ///< pupils to choose from; empty: each pupil types a name
    bool allowsOthers = true;   ///< pupils may type a name that is not in names
    /// Lesson that turns begin with: name of a bundled lesson or absolute path; empty: none.
    QString lesson = {};

    bool operator==(const Classroom&) const = default;
};
} // namespace ui
