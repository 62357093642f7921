#pragma once

#include "app/model/model_history.h"

#include "core/drawing/model_thumbnail.h"
#include "core/util/job_control.h"

#include <QCoreApplication>
#include <QString>
#include <QStringList>

namespace app
{
struct TimeLapseRequest
{
    QString folder; ///< existing folder
    int every = 1;  ///< steps from one picture to the next; the last state always has a picture
    core::ThumbnailView view;
};

/// Result of a time-lapse. If there are neither frames nor a problem, it was cancelled and its files were deleted.
struct TimeLapseOutcome
{
    QString problem; ///< one sentence if it failed; all files that it wrote are then deleted
    int frames = 0;
};

/// Writes the states of a model as numbered PNG files: frame-0001.png and so on. The pictures are opaque, with a light
/// grey background. Existing files are never overwritten. Thread: any.
class TimeLapse
{
    Q_DECLARE_TR_FUNCTIONS(app::TimeLapse)

public:
    /// Returns the file names for the states from `first` to `last`, inclusive.
    static QStringList frameNames(int first, int last, int every);
    /// Returns one sentence if the frames cannot be written, because the folder does not exist or already contains one
    /// of the file names. Returns an empty string otherwise.
    static QString obstacle(const QString& folder, const QStringList& frames);
    /// Writes the frames. Undoes steps in `history.mesh`, which must not be used afterwards.
    static TimeLapseOutcome run(const TimeLapseRequest& request, const ModelHistory& history,
                                const core::JobControl& control);
};
} // namespace app
