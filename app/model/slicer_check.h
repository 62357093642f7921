#pragma once

#include "core/util/job_control.h"

#include <QCoreApplication>
#include <QString>

namespace app
{
/// Tests an exported file with an installed slicer. The check is optional, and its G-code is discarded.
class SlicerCheck
{
    Q_DECLARE_TR_FUNCTIONS(app::SlicerCheck)

public:
    /// Slices the model in a child process, which is killed after three minutes or when the job is cancelled. Returns
    /// one sentence: layers and print time, or the slicer's error. Thread: any. Cost: blocks until the process has
    /// ended; notices cancelling within about 50 ms.
    static QString run(const QString& model, const core::JobControl& control);

private:
    static QString resultIn(const QString& gcode);
};
} // namespace app
