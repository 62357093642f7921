// lesson: plays a lesson to its end without a window and evaluates each checkpoint, or evaluates one checkpoint on a
// pupil's model.
#include "app/commands/class_results.h"
#include "app/commands/command_line.h"
#include "app/commands/lesson_results.h"
#include "app/commands/standard_files.h"
#include "app/lesson/lesson_handout.h"
#include "app/lesson/lesson_library.h"
#include "app/lesson/lesson_messages.h"
#include "app/lesson/lesson_saving.h"
#include "app/model/model_loader.h"

#include "core/io/mesh_io.h"
#include "core/lesson/lesson_playback.h"
#include "core/mesh/mesh_builder.h"
#include "core/util/atomic_file.h"

#include "ui/util/error_messages.h"

#include <QDir>
#include <QImage>
#include <QLocale>
#include <QTranslator>

#include <algorithm>

namespace app
{
namespace
{
using core::CheckpointVerdict; // lupdate misparses a return type written core::CheckpointVerdict

class LessonCommandMessages
{
    Q_DECLARE_TR_FUNCTIONS(app::LessonCommand)
};

const QString picturesName = QStringLiteral("step-%1.png");

struct LessonOptions
{
    QString lesson, language, model, pack, unpack, pictures, out, pdf;
    std::optional<std::size_t> step;         ///< step index, from 0
    std::optional<LessonResults::Form> form; ///< output format for scripts; nothing: text for people
    bool printsTexts = false;
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
        {{QStringLiteral("language"),
          LessonCommandMessages::tr("Language of the lesson and of the answer (default: the system's)."),
          QStringLiteral("CODE")},
         {QStringLiteral("model"),
          LessonCommandMessages::tr("Judge this model of a pupil instead of playing; or -. A folder, or a class's work "
                                    "folder: judge each model."),
          QStringLiteral("FILE|FOLDER")},
         {QStringLiteral("step"),
          LessonCommandMessages::tr("Step whose checkpoint judges the model, from 1 (default: the last)."),
          QStringLiteral("N")},
         {QStringLiteral("pack"), LessonCommandMessages::tr("File for the whole lesson, if all is well."),
          QStringLiteral("OUT.zip")},
         {QStringLiteral("unpack"), LessonCommandMessages::tr("Folder for the lesson, where it can be changed."),
          QStringLiteral("FOLDER")},
         {QStringLiteral("pictures"),
          LessonCommandMessages::tr("Folder for a picture of the result of each step, step-1.png and so on."),
          QStringLiteral("FOLDER")},
         {{QStringLiteral("o"), QStringLiteral("out")},
          LessonCommandMessages::tr("File for the model that the last step leaves."),
          QStringLiteral("FILE")},
         {QStringLiteral("pdf"),
          LessonCommandMessages::tr("File for a handout: what pupils read, with the pictures; instead of playing."),
          QStringLiteral("OUT.pdf")},
         {QStringLiteral("texts"), LessonCommandMessages::tr("Print what pupils read, instead of playing.")},
         {QStringLiteral("json"),
          LessonCommandMessages::tr("JSON: one object; of a folder of models, one for each, on a line of its own; "
                                    "without a lesson, the list of the program's.")},
         {QStringLiteral("csv"),
          LessonCommandMessages::tr("CSV with a header row: a row for each goal; of a folder, for each model.")}});
    StandardFiles::addFrom(parser);
    CommandOptions::addNoClobber(parser);
}

/// Sets the language of the program's own texts to that of the lesson's texts (--language), if there is a translation.
void answerIn(const QString& language)
{
    const QLocale locale(language);
    auto translator = std::make_unique<QTranslator>();
    if (!translator->load(locale, QStringLiteral("fettle"), QStringLiteral("_"), QStringLiteral(":/i18n")))
        return;
    QCoreApplication* const application = QCoreApplication::instance();
    // the English translation has only a few texts; for the others, an earlier translator would be used
    qDeleteAll(application->findChildren<QTranslator*>());
    translator->setParent(application);
    QCoreApplication::installTranslator(translator.release());
    QLocale::setDefault(locale);
}

/// Fails if a file or folder to be written has a wrong extension or exists already.
void requireFit(const LessonOptions& options, const CommandOptions& given)
{
    if (!options.pack.isEmpty() && !options.pack.endsWith(QLatin1String(".zip"), Qt::CaseInsensitive))
        CommandLine::fail(LessonCommandMessages::tr("lesson: %1 does not end in .zip.").arg(options.pack));
    if (options.unpack.endsWith(QLatin1String(".zip"), Qt::CaseInsensitive))
        CommandLine::fail(
            LessonCommandMessages::tr("lesson: %1 must be a folder, but ends in .zip.").arg(options.unpack));
    if (!options.pdf.isEmpty() && !options.pdf.endsWith(QLatin1String(".pdf"), Qt::CaseInsensitive))
        CommandLine::fail(LessonCommandMessages::tr("lesson: %1 does not end in .pdf.").arg(options.pdf));
    for (const QString& path : {options.pack, options.unpack, options.out, options.pdf})
        given.requireFree(path);
    if (options.pictures.isEmpty())
        return;
    if (!QFileInfo(options.pictures).isDir())
        CommandLine::fail(LessonCommandMessages::tr("%1 is not a folder.").arg(options.pictures));
    const QDir folder(options.pictures);
    for (const QString& picture : folder.entryList({picturesName.arg(QStringLiteral("*"))}))
        given.requireFree(folder.filePath(picture));
}

std::optional<LessonOptions> parseLessonOptions(const QStringList& arguments)
{
    QCommandLineParser parser;
    addLessonOptions(parser);
    const CommandOptions given(parser, QStringLiteral("lesson"), arguments);
    if (given.isAnswered())
        return std::nullopt;
    const QString model = QStringLiteral("model"), step = QStringLiteral("step"), json = QStringLiteral("json"),
                  csv = QStringLiteral("csv"), texts = QStringLiteral("texts"), pdf = QStringLiteral("pdf");
    const QStringList lessons = given.files();
    if (lessons.size() > 1)
        CommandLine::fail(LessonCommandMessages::tr("lesson: one lesson at a time can be played, not %1 as well.")
                              .arg(lessons.at(1)));
    LessonOptions options{lessons.value(0),
                          given.text(QStringLiteral("language")),
                          given.text(model),
                          given.text(QStringLiteral("pack")),
                          given.text(QStringLiteral("unpack")),
                          given.text(QStringLiteral("pictures")),
                          given.text(QStringLiteral("out")),
                          given.text(QStringLiteral("pdf")),
                          {},
                          {}};
    if (options.language.isEmpty())
        options.language = QLocale().name();
    else
        answerIn(options.language);
    const QStringList ofPlaying{QStringLiteral("pack"), QStringLiteral("unpack"), QStringLiteral("pictures"),
                                QStringLiteral("out")};
    options.printsTexts = given.has(texts);
    for (const QString& option : ofPlaying) {
        given.requireOneOf(model, option);
        given.requireOneOf(texts, option);
        given.requireOneOf(pdf, option);
    }
    for (const QString& option : {model, json, csv, pdf})
        given.requireOneOf(texts, option);
    for (const QString& option : {model, json, csv})
        given.requireOneOf(pdf, option);
    const bool plays = std::ranges::any_of(ofPlaying, [&](const QString& option) { return given.has(option); });
    if (options.lesson.isEmpty() &&
        (plays || given.has(model) || given.has(step) || given.has(pdf) || options.printsTexts))
        CommandLine::fail(LessonCommandMessages::tr("lesson: no lesson was given."));
    given.requireWith({step}, model);
    if (given.has(step))
        options.step = given.wholeNumber(step, 1) - 1;
    given.requireOneOf(json, csv);
    if (given.has(json) || given.has(csv))
        options.form = given.has(json) ? LessonResults::Form::Json : LessonResults::Form::Csv;
    requireFit(options, given);
    options.model = StandardFiles::input(given, options.model);
    return options;
}

QString inLanguage(const core::LessonText& text, const LessonOptions& options)
{
    return QString::fromStdString(text.in(options.language.toStdString()));
}

void list(const LessonOptions& options)
{
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const QString& name : bundledLessons()) {
        const core::Lesson lesson = readLesson(name);
        const QString title = inLanguage(lesson.title, options), summary = inLanguage(lesson.summary, options);
        rows.push_back(
            {{"lesson", name.toStdString()}, {"title", title.toStdString()}, {"summary", summary.toStdString()}});
        if (!options.form)
            CommandLine::print(QStringLiteral("%1  %2. %3\n").arg(name, -12).arg(title, summary));
    }
    if (options.form)
        CommandLine::print(*options.form == LessonResults::Form::Csv ? csvOf(rows)
                                                                     : QString::fromStdString(rows.dump()) + u'\n');
}

/// Prints the verdict. Returns whether it is met.
bool print(const core::CheckpointVerdict& verdict)
{
    const auto line = [](bool holds, const QString& goal) {
        CommandLine::print(QStringLiteral("   %1  %2\n")
                               .arg(holds ? LessonCommandMessages::tr("yes") : LessonCommandMessages::tr("no"), -4)
                               .arg(goal));
    };
    for (const core::FactVerdict& fact : verdict.facts)
        line(fact.holds, LessonMessages::goal(fact));
    if (verdict.target)
        line(verdict.target->holds, LessonMessages::goal(*verdict.target));
    if (verdict.facts.empty() && !verdict.target)
        CommandLine::print(QStringLiteral("   %1\n").arg(LessonCommandMessages::tr("no goal")));
    return verdict.isMet();
}

void printHead(const core::LessonStep& step, std::size_t index, const LessonOptions& options)
{
    QStringList tools;
    for (const core::Tool tool : step.tools)
        tools << LessonMessages::tool(tool);
    CommandLine::print(LessonCommandMessages::tr("%1. %2 (strokes: %3; tools: %4)")
                           .arg(index + 1)
                           .arg(inLanguage(step.title, options))
                           .arg(step.strokes.size())
                           .arg(tools.isEmpty() ? LessonCommandMessages::tr("all") : tools.join(QStringLiteral(", "))) +
                       QLatin1Char('\n'));
}

void draw(const core::TriangleMesh& mesh, const core::LessonStep& step, const QString& path)
{
    if (!lessonPicture(mesh, step.view).save(path))
        CommandLine::fail(LessonCommandMessages::tr("%1: this picture cannot be written.").arg(path));
}

void printTexts(const core::Lesson& lesson, const LessonOptions& options)
{
    QString text = inLanguage(lesson.title, options) + u'\n' + inLanguage(lesson.summary, options) + u'\n';
    for (std::size_t i = 0; i < lesson.steps.size(); ++i)
        text += QStringLiteral("\n%1. %2\n%3\n")
                    .arg(i + 1)
                    .arg(inLanguage(lesson.steps[i].title, options), inLanguage(lesson.steps[i].text, options));
    CommandLine::print(text);
}

/// The lesson that is being played or evaluated.
struct Session
{
    const core::Lesson& lesson;
    core::LessonPlayback& playback;
    const LessonOptions& options;
    std::optional<LessonResults> results; ///< results for scripts; nothing: text is printed for people
};

/// Evaluates the checkpoint of the playback's present step on the model, and prints or records the verdict. Returns
/// whether it is met.
bool judge(Session& session, std::size_t index, const core::TriangleMesh& model)
{
    const core::LessonStep& step = session.playback.step();
    const core::TriangleMesh target = step.checkpoint.target ? session.playback.target() : core::TriangleMesh();
    const core::CheckpointVerdict verdict =
        core::evaluate(step.checkpoint, model, step.checkpoint.target ? &target : nullptr);
    if (session.results) {
        session.results->add(index, inLanguage(step.title, session.options), step, verdict);
        return verdict.isMet();
    }
    printHead(step, index, session.options);
    return print(verdict);
}

ExitStatus play(Session& session)
{
    const LessonOptions& options = session.options;
    const core::Lesson& lesson = session.lesson;
    core::LessonPlayback& playback = session.playback;
    if (!session.results)
        CommandLine::print(QStringLiteral("%1\n").arg(inLanguage(lesson.title, options)));
    bool isMet = true;
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
        playback.goTo(i);
        playback.finish();
        const core::TriangleMesh mesh = core::extractMesh(playback.mesh());
        isMet = judge(session, i, mesh) && isMet;
        if (!options.pictures.isEmpty())
            draw(mesh, playback.step(), QDir(options.pictures).filePath(picturesName.arg(i + 1)));
    }
    if (!options.out.isEmpty())
        core::writeMesh(toPath(options.out), core::extractMesh(playback.mesh()));
    if (isMet && !options.pack.isEmpty())
        core::writeLesson(toPath(options.pack), lesson);
    if (!options.unpack.isEmpty())
        core::writeLesson(toPath(options.unpack), lesson);
    return isMet ? Done : AnswerIsNo;
}

/// Goes to the step whose checkpoint is to be evaluated.
void goToJudgedStep(Session& session)
{
    const core::Lesson& lesson = session.lesson;
    const std::size_t step = session.options.step.value_or(lesson.steps.size() - 1);
    if (step >= lesson.steps.size())
        CommandLine::fail(LessonCommandMessages::tr("lesson: there is no step %1: the last one is %2.")
                              .arg(step + 1)
                              .arg(lesson.steps.size()));
    if (lesson.steps[step].checkpoint.asksNothing())
        CommandLine::fail(LessonCommandMessages::tr("lesson: step %1 has no checkpoint.").arg(step + 1));
    session.playback.goTo(step);
}

ExitStatus checkModel(Session& session)
{
    const core::TriangleMesh model = core::readMesh(toPath(session.options.model));
    goToJudgedStep(session);
    return judge(session, session.playback.stepIndex(), model) ? Done : AnswerIsNo;
}

/// Returns a verdict with the goals of a checkpoint, but without measured values.
CheckpointVerdict unanswered(const core::Checkpoint& checkpoint)
{
    CheckpointVerdict verdict;
    for (const core::FactBounds& asked : checkpoint.facts)
        verdict.facts.push_back({asked, std::nullopt, false});
    if (checkpoint.target)
        verdict.target.emplace().tolerance = checkpoint.target->tolerance;
    return verdict;
}

/// Evaluates each model of a folder. Models that cannot be read are reported on standard error.
ExitStatus checkFolder(Session& session)
{
    const QList<FoundModel> models = modelsAndWorks(toPath(session.options.model));
    goToJudgedStep(session);
    const std::size_t index = session.playback.stepIndex();
    const core::LessonStep& step = session.playback.step();
    const core::TriangleMesh target = step.checkpoint.target ? session.playback.target() : core::TriangleMesh();
    std::optional<ClassResults> results;
    if (session.options.form)
        results.emplace(*session.options.form, session.options.lesson, index, inLanguage(step.title, session.options));
    else
        printHead(step, index, session.options);
    ExitStatus status = Done;
    for (const FoundModel& model : models) {
        try {
            const core::CheckpointVerdict verdict =
                core::evaluate(step.checkpoint, core::readMesh(model.file), step.checkpoint.target ? &target : nullptr);
            status = std::max(status, verdict.isMet() ? Done : AnswerIsNo);
            if (results) {
                results->add(model, verdict);
                continue;
            }
            CommandLine::print(model.title() + u'\n');
            print(verdict);
        } catch (const core::FileError& error) {
            const QString problem = ui::ErrorMessages::sentence(error);
            CommandLine::printError(problem);
            status = BadInput;
            if (results)
                results->add(model, unanswered(step.checkpoint), problem);
        }
    }
    if (results)
        CommandLine::print(results->text());
    return status;
}

/// Fails if the word is neither a bundled lesson nor an existing file or folder.
void requireLesson(const QString& word)
{
    if (!QFileInfo::exists(word) && !bundledLessons().contains(word))
        CommandLine::fail(LessonCommandMessages::tr(
                              "lesson: \"%1\" is not a lesson: it is neither one of %2 nor a folder or ZIP file.")
                              .arg(word, bundledLessons().join(QStringLiteral(", "))));
}

ExitStatus run(const LessonOptions& options)
{
    const auto lesson = std::make_shared<const core::Lesson>(readLesson(options.lesson));
    if (options.printsTexts) {
        printTexts(*lesson, options);
        return Done;
    }
    if (!options.pdf.isEmpty()) {
        core::AtomicFile file(toPath(options.pdf));
        file.write(lessonHandout(*lesson, options.language).toStdString());
        file.commit();
        return Done;
    }
    core::LessonPlayback playback(lesson, toPath(options.lesson));
    Session session{*lesson, playback, options, {}};
    if (!options.model.isEmpty() && QFileInfo(options.model).isDir())
        return checkFolder(session);
    if (options.form)
        session.results.emplace(*options.form, options.lesson, inLanguage(lesson->title, options),
                                StandardFiles::named(options.model));
    const ExitStatus status = options.model.isEmpty() ? play(session) : checkModel(session);
    if (session.results)
        CommandLine::print(session.results->text());
    return status;
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
        requireLesson(options->lesson);
        return run(*options);
    } catch (const core::LessonError& error) {
        CommandLine::fail(LessonMessages::sentence(error));
    } catch (const core::FileError& error) {
        CommandLine::fail(ui::ErrorMessages::sentence(error));
    }
}
} // namespace app
