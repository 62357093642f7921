#include "app/classroom/report_writer.h"

#include "app/classroom/class_works.h"
#include "app/classroom/turn_answers.h"
#include "app/model/model_loader.h"

#include "core/drawing/model_thumbnail.h"
#include "core/geometry/scale_mesh.h"
#include "core/io/mesh_io.h"
#include "ui/files/thumbnail_maker.h"
#include "ui/util/error_messages.h"
#include "ui/util/path_display.h"

#include <new>

namespace app
{
namespace
{
constexpr int picturePixels = 192; ///< side of a picture, which is 18 mm on paper: about 270 pixels per inch

/// Returns the folder's name, also for the paths "." and "..".
QString folderName(const std::filesystem::path& folder)
{
    std::error_code problem;
    const std::filesystem::path whole = std::filesystem::canonical(folder, problem);
    return ui::displayName(whole.has_filename() ? whole.filename() : folder);
}

} // namespace

QStringList ReportWriter::run(const ReportRequest& request, const core::JobControl& control)
{
    core::AtomicFile file(request.file); // made first, so that nothing is checked if the report cannot be written
    const QList<FoundModel> models = modelsAndWorks(request.folder);
    ui::ClassReport report{folderName(request.folder), QDate::currentDate(), {}};
    QStringList unreadable;
    for (const FoundModel& model : models) {
        ui::ReportRow row = rowOf(model.file, request.unit, control);
        if (!model.work.isEmpty()) {
            const TurnAnswers answers = TurnAnswers::read(model.work);
            row.name = model.pupil;
            row.turnSeconds = model.turn.seconds();
            row.answersProblem = answers.problem;
            row.lesson = model.turn.lesson ? model.turn.lesson->sentence() : QString();
            if (!answers.questionnaire.isEmpty())
                report.questionnaires << answers.questionnaire;
        }
        if (!row.problem.isEmpty())
            unreadable << (row.name.isEmpty() ? row.problem : QStringLiteral("%1: %2").arg(row.name, row.problem));
        report.rows << row;
        control.reportProgress(static_cast<double>(report.rows.size()) / static_cast<double>(models.size()));
    }
    ui::writeReport(file, report);
    if (control.isCancelled())
        throw core::ReadingCancelled();
    file.commit();
    return unreadable;
}

/// Returns the row of a file. Its error sentence names the file without its folder, as the row does.
ui::ReportRow ReportWriter::rowOf(const std::filesystem::path& file, double unit, const core::JobControl& control)
{
    ui::ReportRow row{file, {}, {}, {}, {}};
    try {
        examine(row, unit, control);
    } catch (core::FileError& error) {
        error.path = error.path.filename();
        row.problem = ui::ErrorMessages::sentence(error);
    } catch (const std::bad_alloc&) {
        row.report.reset();
        row.problem = tr("%1: there is not enough memory for this model.").arg(ui::displayName(file.filename()));
    }
    return row;
}

void ReportWriter::examine(ui::ReportRow& row, double unit, const core::JobControl& control)
{
    core::TriangleMesh mesh = core::readMesh(row.file, {.stop = control.stop});
    if (unit != 1 && !core::scaleMesh(mesh, unit)) {
        row.problem = ui::ErrorMessages::tooLarge(ui::displayName(row.file.filename()));
        return;
    }
    const std::optional<core::ModelThumbnail> picture = core::drawThumbnail(mesh, picturePixels, control.stop);
    row.report = core::checkMesh(mesh, {control.stop, {}});
    if (!picture || control.isCancelled())
        throw core::ReadingCancelled();
    row.picture = ui::toImage(*picture);
    row.work = core::readMetadata(row.file).work;
}
} // namespace app
