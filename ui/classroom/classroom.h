#pragma once

#include "ui/settings/preferences.h"

#include "core/operations/starter_models.h"
#include "core/stroke/tool.h"

#include <QList>
#include <QString>
#include <QStringList>

namespace ui
{
inline constexpr int maxTurnMinutes = 240;
inline constexpr int maxPupilNames = 200, maxPupilNameLength = 40; ///< characters
inline constexpr int minPinLength = 4, maxPinLength = 32;          ///< characters

/// What a teacher has chosen for a class.
struct Classroom
{
    QString title;
    QString folder;                ///< an absolute path: there the pupils' works go
    QList<core::Starter> starters; ///< none twice, and at least one, or a lesson; the first is there before all choose
    QList<core::Tool> tools;       ///< the same; the first is in the hand when a turn begins
    int turnMinutes = 20;          ///< 0: a turn has no end
    int warningMinutes = 3;        ///< before that end; 0: no warning
    bool fullScreen = true;
    Language language = Language::System;
    QString pin = {};           ///< as app/class_pin writes it, never the digits themselves
    bool asksQuestions = false; ///< six about the program, after each turn
    QStringList names = {};     ///< of the pupils, to choose from; none: each is typed
    bool allowsOthers = true;   ///< a name that is not among them may be typed, too
    QString lesson = {};        ///< to begin with: one of ours, or an absolute path; empty: none

    bool operator==(const Classroom&) const = default;
};
} // namespace ui
