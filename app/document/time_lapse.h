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
    QString folder; ///< that is there
    int every = 1;  ///< steps from one picture to the next; the last state is always among them
    core::ThumbnailView view;
};

/// What became of it: no frames and no problem if it was stopped.
struct TimeLapseOutcome
{
    QString problem; ///< one sentence; none of its frames is left then
    int frames = 0;
};

/// The states of a model as numbered PNG files, frame-0001.png and so on: opaque, the model on a light grey. A file
/// that is there is never written over. Any thread.
class TimeLapse
{
    Q_DECLARE_TR_FUNCTIONS(app::TimeLapse)

public:
    /// From `first` to `last`, which are both among them.
    static QStringList frameNames(int first, int last, int every);
    /// One sentence if the frames cannot be written there: there is no such folder, or one of them is there already.
    /// Else empty.
    static QString obstacle(const QString& folder, const QStringList& frames);
    /// Consumes the history's mesh.
    static TimeLapseOutcome run(const TimeLapseRequest& request, const ModelHistory& history,
                                const core::JobControl& control);
};
} // namespace app
