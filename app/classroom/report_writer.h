#pragma once

#include "core/util/job_control.h"
#include "ui/classroom/class_report.h"

#include <QCoreApplication>

namespace app
{
struct ReportRequest
{
    std::filesystem::path folder;
    std::filesystem::path file; ///< its ending is one of ui::reportEndings()
    double unit = 1;            ///< that the models are measured in, mm
};

/// Looks at every model of a folder and writes the class report. The works of a class's turns in it count, too; their
/// pupils' answers are summed. Any thread; as long as `check` takes, and a picture for each. Needs a QGuiApplication,
/// whose fonts a PDF uses.
class ReportWriter
{
    Q_DECLARE_TR_FUNCTIONS(app::ReportWriter)

public:
    /// A model that cannot be read has its row, too; returns a sentence about each of these. Throws core::FileError if
    /// the folder cannot be read or the report not be written, and core::ReadingCancelled if it was stopped: then
    /// nothing is written.
    static QStringList run(const ReportRequest& request, const core::JobControl& control = {});

private:
    static ui::ReportRow rowOf(const std::filesystem::path& file, double unit, const core::JobControl& control);
    static void examine(ui::ReportRow& row, double unit, const core::JobControl& control);
};
} // namespace app
