#pragma once

#include "core/util/job_control.h"
#include "ui/classroom/class_report.h"

#include <QCoreApplication>

namespace app
{
struct ReportRequest
{
    std::filesystem::path folder;
    std::filesystem::path file; ///< the extension must be in ui::reportEndings()
    double unit = 1;            ///< unit of the models' coordinates, mm
};

/// Checks every model of a folder and writes the class report. Works of a class in the folder are included, with the
/// sums of the pupils' answers. Precondition: a QGuiApplication exists, because a PDF needs its fonts. Thread: any.
/// Cost: as the check command, and one picture for each model.
class ReportWriter
{
    Q_DECLARE_TR_FUNCTIONS(app::ReportWriter)

public:
    /// Writes the report. A model that cannot be read has a row, too. Returns one sentence for each such model. Throws
    /// core::FileError if the folder cannot be read or the report cannot be written. Throws core::ReadingCancelled if
    /// cancelled; no file is then written.
    static QStringList run(const ReportRequest& request, const core::JobControl& control = {});

private:
    static ui::ReportRow rowOf(const std::filesystem::path& file, double unit, const core::JobControl& control);
    static void examine(ui::ReportRow& row, double unit, const core::JobControl& control);
};
} // namespace app
