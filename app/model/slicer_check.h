#pragma once

#include "core/util/job_control.h"

#include <QCoreApplication>
#include <QString>

namespace app
{
/// Has an installed slicer slice a file, and tells what it says. Never needed; its G-code is thrown away.
class SlicerCheck
{
    Q_DECLARE_TR_FUNCTIONS(app::SlicerCheck)

public:
    /// Slices in a child process, which is ended after three minutes, or when the job is cancelled. One sentence:
    /// layers and time, or what the slicer complains of. Any thread; blocks it, at most about 50 ms longer than the
    /// process lives.
    static QString run(const QString& model, const core::JobControl& control);

private:
    static QString resultIn(const QString& gcode);
};
} // namespace app
