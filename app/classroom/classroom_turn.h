#pragma once

#include "app/lesson/lesson_place.h"

#include "core/io/stroke/stroke_file.h"

#include <QDateTime>
#include <QString>

#include <optional>
#include <vector>

namespace app
{
/// The strokes and commands made since the starter; nothing: unknown.
using TurnRecord = std::optional<std::vector<core::FileEntry>>;

/// Returns `before` followed by `after`; nothing if one of them is unknown.
TurnRecord joined(const TurnRecord& before, const TurnRecord& after);

/// A pupil's turn.
struct ClassTurn
{
    QString id;
    QString pupil;
    QDateTime begun;
    qint64 usedMs = 0;                      ///< time used until this object was made, without pauses
    QDateTime ended = {};                   ///< invalid: the turn has not ended
    bool isResumed = false;                 ///< whether the turn continues an earlier work instead of a starter
    std::optional<LessonPlace> lesson = {}; ///< place in the lesson; none: the turn has no lesson
};
} // namespace app
