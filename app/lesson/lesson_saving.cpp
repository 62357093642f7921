#include "app/lesson/lesson_saving.h"

#include "app/lesson/lesson_messages.h"
#include "app/model/command_names.h"
#include "app/worker/stroke_step.h"

#include "core/drawing/model_thumbnail.h"
#include "core/lesson/lesson_check.h"
#include "core/lesson/lesson_file.h"
#include "core/util/system_code.h"
#include "ui/util/error_messages.h"

#include <QBuffer>
#include <QDir>
#include <QLocale>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace app
{
namespace
{
constexpr int pictureSide = 160;      ///< width and height of a picture, pixels
constexpr double afterPlaying = 0.95; ///< progress when the lesson has been played, 0 to 1

std::string pngOf(const QImage& image)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return bytes.toStdString();
}

/// Returns a view from this direction in which the whole model is visible.
core::ThumbnailView seenFrom(const core::LessonView& from, const core::TriangleMesh& mesh)
{
    core::Box box;
    for (const core::Vec3f& p : mesh.points)
        box.extend(core::Vec3(p.cast<double>()));
    constexpr double degree = std::numbers::pi / 180;
    core::ThumbnailView view = core::viewOf(box, pictureSide, pictureSide);
    view.axes = (Eigen::AngleAxisd(from.pitch * degree, core::Vec3::UnitX()) *
                 Eigen::AngleAxisd(-from.yaw * degree, core::Vec3::UnitY()))
                    .toRotationMatrix();
    double reach = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const core::Vec3 at = view.axes * (box.corner(static_cast<core::Box::CornerType>(corner)) - view.target);
        reach = std::max({reach, std::abs(at.x()), std::abs(at.y())});
    }
    view.extent = 2 * 1.05 * reach;
    return view;
}

/// Returns the lesson as it would be after writing and reading it.
core::Lesson readAsWritten(const core::Lesson& lesson, const std::filesystem::path& path)
{
    const std::map<std::string, std::string> files = core::filesOf(lesson);
    return core::readLesson(
        {path, [&files](const std::string& name, std::size_t maxBytes) -> std::optional<std::string> {
             const auto found = files.find(name);
             return found == files.end() ? std::nullopt : std::optional(found->second.substr(0, maxBytes + 1));
         }});
}
} // namespace

QImage lessonPicture(const core::TriangleMesh& mesh, const std::optional<core::LessonView>& from)
{
    const core::ModelThumbnail picture =
        (from ? core::drawThumbnail(mesh, seenFrom(*from, mesh), {}) : core::drawThumbnail(mesh, pictureSide, {}))
            .value();
    return QImage(picture.rgba.data()->data(), picture.width, picture.height, QImage::Format_RGBA8888_Premultiplied)
        .copy();
}

QString LessonSaving::missing(const core::LessonDraft& draft)
{
    const auto missing = draft.missing();
    if (!missing)
        return {};
    switch (missing->what) {
    case core::LessonDraft::Required::Title:
        return tr("The lesson has no title yet.");
    case core::LessonDraft::Required::Steps:
        return tr("The lesson has no steps yet.");
    case core::LessonDraft::Required::StepTitle:
        return tr("Step %1 has no title yet.").arg(missing->step + 1);
    case core::LessonDraft::Required::StepText:
        return tr("Step %1 has no text yet.").arg(missing->step + 1);
    }
    return {};
}

QStringList LessonSaving::remarksOn(const core::LessonStep& step, std::size_t index, const core::StepCheck& check)
{
    QStringList remarks;
    for (const std::size_t stroke : check.idle)
        remarks << tr("Step %1, stroke %2 (%3) no longer changes anything.")
                       .arg(index + 1)
                       .arg(stroke + 1)
                       .arg(nameOf(step.strokes[stroke]));
    const auto fault = [&](const QString& goal) {
        //: a step's number; what it asks for, and what the teacher's own model has
        remarks << tr("Step %1 is not met: %2.").arg(index + 1).arg(goal);
    };
    for (const core::FactVerdict& fact : check.verdict.facts)
        if (!fact.holds)
            fault(LessonMessages::goal(fact));
    if (check.verdict.target && !check.verdict.target->holds)
        fault(LessonMessages::goal(*check.verdict.target));
    return remarks;
}

QString LessonSaving::nameOf(const core::FileEntry& entry)
{
    if (const auto* const command = std::get_if<core::FileCommand>(&entry))
        return CommandNames::name(command->command);
    return StrokeStep::textOf(std::get<core::Stroke>(entry).settings.tool);
}

QString LessonSaving::lineOf(const core::Stroke& stroke)
{
    const double radius = stroke.settings.radius;
    //: a stroke's tool and radius
    return tr("%1, %2 mm")
        .arg(StrokeStep::textOf(stroke.settings.tool), QLocale().toString(radius, 'f', radius < 10 ? 1 : 0));
}

CheckedLesson LessonSaving::check(const core::LessonDraft& draft, const std::filesystem::path& path,
                                  const std::optional<std::uint64_t>& hash, const core::JobControl& control)
{
    CheckedLesson checked;
    try {
        core::LessonPlayback playback(std::make_shared<const core::Lesson>(readAsWritten(draft.complete({}), path)),
                                      path);
        std::vector<std::string> pictures(draft.steps());
        const auto draw = [&](std::size_t step, const core::TriangleMesh& mesh) {
            if (draft.makesPicture(step))
                pictures[step] = pngOf(lessonPicture(mesh, draft.step(step).view));
        };
        const std::vector<core::StepCheck> checks = core::checkLesson(playback, draw, control.part(0, afterPlaying));
        if (control.isCancelled())
            return {};
        for (std::size_t i = 0; i < checks.size(); ++i)
            checked.remarks << remarksOn(draft.step(i), i, checks[i]);
        if (hash && playback.mesh().meshHash() != *hash)
            checked.remarks << tr("When replayed, the lesson does not end with the model in the window.");
        auto lesson = std::make_shared<const core::Lesson>(draft.complete(pictures));
        readAsWritten(*lesson, path); // throws if the lesson is too large with its pictures
        checked.lesson = std::move(lesson);
    } catch (const core::LessonError& error) {
        checked.problem = LessonMessages::sentence(error);
        if (!checked.problem.endsWith(QLatin1Char('.')))
            checked.problem += QLatin1Char('.');
    } catch (const core::FileError& error) {
        checked.problem = ui::ErrorMessages::sentence(error);
    }
    return checked;
}

QString LessonSaving::write(const core::Lesson& lesson, const std::filesystem::path& path)
{
    try {
        core::writeLesson(path, lesson);
    } catch (const core::FileError& error) {
        if (core::isSystemCode(error.systemError, std::errc::file_exists))
            return tr("%1 already exists. Choose another name for the lesson's folder.")
                .arg(QDir::toNativeSeparators(QString::fromStdU16String(path.u16string())));
        return ui::ErrorMessages::sentence(error);
    }
    return {};
}
} // namespace app
