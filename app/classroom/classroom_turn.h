#pragma once

#include "app/lesson/lesson_place.h"

#include "core/io/stroke/stroke_file.h"

#include <QDateTime>
#include <QString>

#include <optional>
#include <vector>

namespace app
{
/// What the hands did to a starter; nothing: it is not known.
using TurnRecord = std::optional<std::vector<core::FileEntry>>;

/// The one after the other; nothing if one of them is not known.
TurnRecord joined(const TurnRecord& before, const TurnRecord& after);

/// Whose turn it is.
struct ClassTurn
{
    QString id;
    QString pupil;
    QDateTime begun;
    qint64 usedMs = 0;                      ///< before it was interrupted
    QDateTime ended = {};                   ///< invalid: it goes on
    bool isResumed = false;                 ///< it did not begin with a starter
    std::optional<LessonPlace> lesson = {}; ///< where it is in a lesson; none: it has none
};
} // namespace app
