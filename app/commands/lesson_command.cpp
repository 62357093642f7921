// lesson: a lesson played to its end without a window, and each of its checkpoints evaluated; or one of them on a
// pupil's model.
#include "app/commands/command_line.h"
#include "app/lesson/lesson_library.h"
#include "app/lesson/lesson_messages.h"
#include "app/lesson/lesson_saving.h"
#include "app/model/model_loader.h"

#include "core/io/mesh_io.h"
#include "core/lesson/lesson_playback.h"
#include "core/mesh/mesh_builder.h"

#include "ui/util/error_messages.h"

#include <QDir>
#include <QImage>
#include <QLocale>

#include <algorithm>

namespace app
{
namespace
{
class LessonCommandMessages
{
    Q_DECLARE_TR_FUNCTIONS(app::LessonCommand)
};

struct LessonOptions
{
    QString lesson, language, model, pack, unpack, pictures, out;
    std::optional<std::size_t> step; ///< from 0
};

void addLessonOptions(QCommandLineParser& parser)
{
    parser.setApplicationDescription(
        LessonCommandMessages::tr("Plays a lesson to its end and says whether each step meets its checkpoint. "
                                  "Status 0: all do; 1: not all. Without a lesson: lists those of the program."));
    parser.addPositionalArgument(
        QStringLiteral("LESSON"),
        LessonCommandMessages::tr("A folder or a zip, or the name of a lesson of the program."),
        QStringLiteral("[LESSON]"));
    parser.addOptions(
        {{QStringLiteral("language"), LessonCommandMessages::tr("Of the lesson's titles; else as the system has it."),
          QStringLiteral("CODE")},
         {QStringLiteral("model"), LessonCommandMessages::tr("Judges this model, a pupil's, instead of playing."),
          QStringLiteral("FILE")},
         {QStringLiteral("step"), LessonCommandMessages::tr("By which step's checkpoint; else the last."),
          QStringLiteral("N")},
         {QStringLiteral("pack"), LessonCommandMessages::tr("Where the lesson goes as one file, if all is well."),
          QStringLiteral("OUT.zip")},
         {QStringLiteral("unpack"), LessonCommandMessages::tr("Where the lesson goes as a folder that can be changed."),
          QStringLiteral("FOLDER")},
         {QStringLiteral("pictures"),
          LessonCommandMessages::tr("Where a picture of what each step leaves goes, as step-1.png and so on."),
          QStringLiteral("FOLDER")},
         {QStringLiteral("out"), LessonCommandMessages::tr("Where the model goes that the last step leaves."),
          QStringLiteral("FILE")}});
}

std::optional<LessonOptions> parseLessonOptions(const QStringList& arguments)
{
    QCommandLineParser parser;
    addLessonOptions(parser);
    if (!CommandLine::parse(parser, QStringLiteral("lesson"), arguments))
        return std::nullopt;
    const QStringList lessons = parser.positionalArguments();
    if (lessons.size() > 1)
        CommandLine::fail(LessonCommandMessages::tr("lesson: one lesson at a time can be played, not %1 as well.")
                              .arg(lessons.at(1)));
    LessonOptions options{lessons.value(0),
                          parser.value(QStringLiteral("language")),
                          parser.value(QStringLiteral("model")),
                          parser.value(QStringLiteral("pack")),
                          parser.value(QStringLiteral("unpack")),
                          parser.value(QStringLiteral("pictures")),
                          parser.value(QStringLiteral("out")),
                          {}};
    if (options.language.isEmpty())
        options.language = QLocale().name();
    const QStringList ofPlaying{QStringLiteral("pack"), QStringLiteral("unpack"), QStringLiteral("pictures"),
                                QStringLiteral("out")};
    const bool plays = std::ranges::any_of(ofPlaying, [&](const QString& option) { return parser.isSet(option); });
    if (options.lesson.isEmpty() &&
        (plays || parser.isSet(QStringLiteral("model")) || parser.isSet(QStringLiteral("step"))))
        CommandLine::fail(LessonCommandMessages::tr("lesson: no lesson was given."));
    if (plays && !options.model.isEmpty())
        CommandLine::fail(
            LessonCommandMessages::tr("lesson: --model excludes --pack, --unpack, --pictures and --out."));
    if (parser.isSet(QStringLiteral("step"))) {
        const uint number = parser.value(QStringLiteral("step")).toUInt();
        if (number == 0 || options.model.isEmpty())
            CommandLine::fail(LessonCommandMessages::tr("lesson: --step needs --model, and a step's number, from 1."));
        options.step = number - 1;
    }
    if (!options.pack.isEmpty() && !options.pack.endsWith(QLatin1String(".zip"), Qt::CaseInsensitive))
        CommandLine::fail(LessonCommandMessages::tr("lesson: %1 does not end in .zip.").arg(options.pack));
    if (options.unpack.endsWith(QLatin1String(".zip"), Qt::CaseInsensitive))
        CommandLine::fail(
            LessonCommandMessages::tr("lesson: %1 is to be a folder, but ends in .zip.").arg(options.unpack));
    return options;
}

QString inLanguage(const core::LessonText& text, const LessonOptions& options)
{
    return QString::fromStdString(text.in(options.language.toStdString()));
}

void list(const LessonOptions& options)
{
    for (const QString& name : bundledLessons()) {
        const core::Lesson lesson = readLesson(name);
        CommandLine::print(QStringLiteral("%1  %2: %3\n")
                               .arg(name, -12)
                               .arg(inLanguage(lesson.title, options), inLanguage(lesson.summary, options)));
    }
}

/// Says the verdict; whether it is met.
bool print(const core::CheckpointVerdict& verdict)
{
    const auto line = [](bool holds, const QString& asked, const QString& found) {
        CommandLine::print(QStringLiteral("   %1  %2 (%3)\n")
                               .arg(holds ? LessonCommandMessages::tr("yes") : LessonCommandMessages::tr("no"), -4)
                               .arg(asked, found));
    };
    for (const core::FactVerdict& fact : verdict.facts)
        line(fact.holds, LessonMessages::asked(fact.asked), LessonMessages::found(fact));
    if (verdict.target)
        line(verdict.target->holds, LessonMessages::asked(core::CheckpointTarget{{}, verdict.target->tolerance}),
             LessonMessages::found(*verdict.target));
    return verdict.isMet();
}

void printHead(const core::LessonStep& step, std::size_t index, const LessonOptions& options)
{
    QStringList tools;
    for (const core::Tool tool : step.tools)
        tools << QString::fromUtf8(core::name(tool));
    CommandLine::print(LessonCommandMessages::tr("%1. %2 (strokes: %3; tools: %4)")
                           .arg(index + 1)
                           .arg(inLanguage(step.title, options))
                           .arg(step.strokes.size())
                           .arg(tools.isEmpty() ? LessonCommandMessages::tr("all") : tools.join(QStringLiteral(", "))) +
                       QLatin1Char('\n'));
}

void draw(const core::TriangleMesh& mesh, const QString& path)
{
    if (!lessonPicture(mesh).save(path))
        CommandLine::fail(LessonCommandMessages::tr("%1: this picture cannot be written.").arg(path));
}

ExitStatus play(const core::Lesson& lesson, core::LessonPlayback& playback, const LessonOptions& options)
{
    CommandLine::print(QStringLiteral("%1\n").arg(inLanguage(lesson.title, options)));
    bool isMet = true;
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
        playback.goTo(i);
        playback.finish();
        const core::TriangleMesh mesh = core::extractMesh(playback.mesh());
        const core::Checkpoint& checkpoint = playback.step().checkpoint;
        printHead(playback.step(), i, options);
        const core::TriangleMesh target = checkpoint.target ? playback.target() : core::TriangleMesh();
        isMet = print(core::evaluate(checkpoint, mesh, checkpoint.target ? &target : nullptr)) && isMet;
        if (!options.pictures.isEmpty())
            draw(mesh, QDir(options.pictures).filePath(QStringLiteral("step-%1.png").arg(i + 1)));
    }
    if (!options.out.isEmpty())
        core::writeMesh(toPath(options.out), core::extractMesh(playback.mesh()));
    if (isMet && !options.pack.isEmpty())
        core::writeLesson(toPath(options.pack), lesson);
    if (!options.unpack.isEmpty())
        core::writeLesson(toPath(options.unpack), lesson);
    return isMet ? Done : AnswerIsNo;
}

ExitStatus checkModel(const core::Lesson& lesson, core::LessonPlayback& playback, const LessonOptions& options)
{
    const std::size_t step = options.step.value_or(lesson.steps.size() - 1);
    if (step >= lesson.steps.size())
        CommandLine::fail(LessonCommandMessages::tr("lesson: there is no step %1: the lesson has %2.")
                              .arg(step + 1)
                              .arg(lesson.steps.size()));
    if (lesson.steps[step].checkpoint.asksNothing())
        CommandLine::fail(LessonCommandMessages::tr("lesson: step %1 has no checkpoint.").arg(step + 1));
    const core::TriangleMesh model = core::readMesh(toPath(options.model));
    playback.goTo(step);
    printHead(playback.step(), step, options);
    const bool hasTarget = playback.step().checkpoint.target.has_value();
    const core::TriangleMesh target = hasTarget ? playback.target() : core::TriangleMesh();
    return print(core::evaluate(playback.step().checkpoint, model, hasTarget ? &target : nullptr)) ? Done : AnswerIsNo;
}
} // namespace

ExitStatus lessonCommand(const QStringList& arguments)
{
    const std::optional<LessonOptions> options = parseLessonOptions(arguments);
    if (!options)
        return Done;
    if (!options->out.isEmpty())
        CommandLine::requireMeshEnding(options->out);
    try {
        if (options->lesson.isEmpty()) {
            list(*options);
            return Done;
        }
        const auto lesson = std::make_shared<const core::Lesson>(readLesson(options->lesson));
        core::LessonPlayback playback(lesson, toPath(options->lesson));
        return options->model.isEmpty() ? play(*lesson, playback, *options) : checkModel(*lesson, playback, *options);
    } catch (const core::LessonError& error) {
        CommandLine::fail(LessonMessages::sentence(error));
    } catch (const core::FileError& error) {
        CommandLine::fail(ui::ErrorMessages::sentence(error));
    }
}
} // namespace app
