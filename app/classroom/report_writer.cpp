#include "app/classroom/report_writer.h"

#include "core/io/mesh_io.h"
#include "core/drawing/model_thumbnail.h"
#include "core/geometry/scale_mesh.h"
#include "ui/util/error_messages.h"
#include "ui/util/path_display.h"
#include "ui/files/thumbnail_maker.h"

#include <new>

namespace app
{
namespace
{
constexpr int picturePixels = 192; ///< on paper 18 mm: some 270 an inch

/// Also of "." and "..".
QString folderName(const std::filesystem::path& folder)
{
    std::error_code problem;
    const std::filesystem::path whole = std::filesystem::canonical(folder, problem);
    return ui::shownName(whole.has_filename() ? whole.filename() : folder);
}
} // namespace

void ReportMaker::run(const ReportOrder& order, const core::JobWatch& watch)
{
    core::AtomicFile file(order.file); // where nothing can be written, nothing is looked at
    const QList<std::filesystem::path> models = ui::modelsIn(order.folder);
    ui::ClassReport report{folderName(order.folder), QDate::currentDate(), {}};
    for (const std::filesystem::path& model : models) {
        report.rows << rowOf(model, order.unit, watch);
        watch.reached(static_cast<double>(report.rows.size()) / static_cast<double>(models.size()));
    }
    ui::writeReport(file, report);
    if (watch.stopped())
        throw core::ReadingStopped();
    file.commit();
}

/// In its sentence a file is called by its name alone: that is what the row is called, too.
ui::ReportRow ReportMaker::rowOf(const std::filesystem::path& file, double unit, const core::JobWatch& watch)
{
    ui::ReportRow row{file, {}, {}, {}, {}};
    try {
        lookAt(row, unit, watch);
    } catch (core::FileError& error) {
        error.path = error.path.filename();
        row.problem = ui::Messages::sentence(error);
    } catch (const std::bad_alloc&) {
        row.report.reset();
        row.problem = tr("%1: there is not enough memory for this model.").arg(ui::shownName(file.filename()));
    }
    return row;
}

void ReportMaker::lookAt(ui::ReportRow& row, double unit, const core::JobWatch& watch)
{
    core::TriangleMesh mesh = core::readMesh(row.file, {.stop = watch.stop});
    if (unit != 1 && !core::scale(mesh, unit)) {
        row.problem = ui::Messages::tooLarge(ui::shownName(row.file.filename()));
        return;
    }
    const std::optional<core::ModelPicture> picture = core::drawPicture(mesh, picturePixels, watch.stop);
    row.report = core::checkMesh(mesh, {watch.stop, {}});
    if (!picture || watch.stopped())
        throw core::ReadingStopped();
    row.picture = ui::toImage(*picture);
    row.work = core::readNotes(row.file).work;
}
} // namespace app
