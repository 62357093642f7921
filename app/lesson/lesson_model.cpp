#include "app/lesson/lesson_model.h"

#include "app/lesson/lesson_messages.h"

#include "core/io/mesh_io.h"
#include "core/lesson/lesson_playback.h"
#include "ui/util/error_messages.h"

#include <QFile>
#include <QFileInfo>
#include <QLocale>
#include <QRegularExpression>
#include <QTemporaryDir>

namespace app
{
namespace
{
QString sentenceOf(const core::LessonError& error)
{
    const QString sentence = LessonMessages::sentence(error);
    return sentence.endsWith(QLatin1Char('.')) ? sentence : sentence + QLatin1Char('.');
}

/// Plays the first `steps` steps one stroke at a time, so that it can be cancelled between strokes.
void play(core::LessonPlayback& playback, std::size_t steps, const core::JobControl& control)
{
    std::size_t all = 0, done = 0;
    for (std::size_t i = 0; i < steps; ++i)
        all += playback.lesson().steps[i].strokes.size();
    for (std::size_t i = 0; i < steps; ++i) {
        playback.goTo(i);
        for (; playback.done() < playback.step().strokes.size() && !control.isCancelled(); ++done) {
            control.reportProgress(static_cast<double>(done) / static_cast<double>(all));
            playback.playNext();
        }
    }
}
} // namespace

LoadedModel LessonModel::load(const core::JobControl& control) const
{
    LoadedModel loaded;
    loaded.name = name.isEmpty() ? fileNameOf(*lesson) : name;
    loaded.metadata.work.emplace(); // a new model: its work counters start at zero
    try {
        core::LessonPlayback playback(lesson, path);
        play(playback, steps, control);
        if (control.isCancelled())
            return loaded;
        core::LessonPlayback::Released left = std::move(playback).release();
        loaded.sculptor = std::move(left.sculptor);
        loaded.start = std::move(left.start);
    } catch (const core::LessonError& error) {
        loaded.problem = sentenceOf(error);
    } catch (const core::FileError& error) {
        loaded.problem = ui::ErrorMessages::sentence(error);
    }
    return loaded;
}

std::string lessonStartOf(const core::TriangleMesh& mesh)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QLatin1StringView(lessonStart));
    core::writeMesh(toPath(path), mesh);
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        throw core::FileError(core::FileErrorKind::NotReadable, toPath(path));
    return file.readAll().toStdString();
}

QString inOurLanguage(const core::LessonText& text)
{
    return QString::fromStdString(text.in(QLocale().name().toStdString()));
}

QString fileNameOf(const core::Lesson& lesson)
{
    static const QRegularExpression notInNames(QStringLiteral(R"([\\/:*?"<>|])"));
    QString title = inOurLanguage(lesson.title);
    title.replace(QStringLiteral(": "), QStringLiteral(" – ")).replace(QStringLiteral("："), QStringLiteral("——"));
    return title.replace(notInNames, QStringLiteral(" ")).simplified();
}

QString lessonOrItsFolder(const QString& path)
{
    const QFileInfo file(path);
    return file.fileName() == QLatin1String("lesson.json") ? file.absolutePath() : path;
}

ReadLesson tryToReadLesson(const QString& pathOrName, core::Lesson (*read)(const QString& pathOrName))
{
    try {
        return {std::make_shared<const core::Lesson>(read(pathOrName)), {}};
    } catch (const core::LessonError& error) {
        return {{}, sentenceOf(error)};
    } catch (const core::FileError& error) {
        return {{}, ui::ErrorMessages::sentence(error)};
    }
}
} // namespace app
