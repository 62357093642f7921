#include "app/lesson/lesson_messages.h"

#include "app/worker/stroke_step.h"

#include "ui/util/error_messages.h"
#include "ui/util/number_format.h"
#include "ui/util/stroke_file_messages.h"

#include <QDir>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace app
{
namespace
{
using Kind = core::LessonError::Kind;

QString bytes(double count)
{
    return QLocale().formattedDataSize(static_cast<qint64>(count));
}

/// Returns a length in mm, without decimals if it is a whole number.
QString millimetres(double length)
{
    const bool isWhole = std::abs(length - std::round(length)) < 0.05;
    return QLocale().toString(length, 'f', isWhole ? 0 : 1);
}
} // namespace

QString LessonMessages::sentence(const core::LessonError& error)
{
    const QString path = QDir::toNativeSeparators(QString::fromStdU16String(error.path.u16string())),
                  where = place(error);
    return where.isEmpty() ? tr("%1: %2", "file: reason").arg(path, reason(error))
                           : tr("%1: %2: %3", "file: place: reason").arg(path, where, reason(error));
}

QString LessonMessages::place(const core::LessonError& error)
{
    QStringList places;
    if (!error.file.empty())
        places << QString::fromStdString(error.file);
    if (error.step)
        //: counted from 1; in brackets as in the file, counted from 0
        places << tr("step %1 (steps[%2])").arg(*error.step + 1).arg(*error.step);
    if (error.line > 0)
        places << tr("line %1, byte %2").arg(error.line).arg(error.byte);
    if (error.strokes)
        if (const QString stroke = ui::StrokeFileMessages::place(*error.strokes); !stroke.isEmpty())
            places << stroke;
    return places.join(QStringLiteral(", "));
}

QString LessonMessages::reason(const core::LessonError& error)
{
    const QString words = json(error);
    return words.isEmpty() ? files(error) : words;
}

/// Returns the reason for an error in lesson.json; empty for other errors.
QString LessonMessages::json(const core::LessonError& error)
{
    const QString key = QString::fromStdString(error.key);
    switch (error.kind) {
    case Kind::NotALesson:
        return tr("its lesson.json is not a lesson of Fettle");
    case Kind::Newer:
        return tr("this lesson was made for a newer version of the program (format %1; this one reads format 1)")
            .arg(error.version);
    case Kind::Syntax:
        return tr("its lesson.json is not JSON");
    case Kind::TooDeep:
        return tr("its lesson.json nests deeper than a lesson does");
    case Kind::DuplicateKey:
        return tr("\"%1\" appears twice").arg(key);
    case Kind::UnknownKey:
        return tr("unknown key %1").arg(key);
    case Kind::MissingKey:
        return tr("\"%1\" is missing").arg(key);
    case Kind::WrongType:
        return wrongType(error.key);
    case Kind::UnknownValue:
        return tr("unknown value, %1").arg(key);
    case Kind::OutOfRange:
        return tr("\"%1\" is out of range, %2 to %3")
            .arg(key, QString::number(error.min, 'g', 6), QString::number(error.max, 'g', 6));
    case Kind::NoWords:
        return tr("\"%1\" has no text in some language").arg(key);
    case Kind::TooLong:
        return tr("\"%1\" is too long: at most %2 of text are read").arg(key, bytes(error.max));
    case Kind::TooMany:
        return key.isEmpty()
                   ? tr("it contains too many files: at most %1 are allowed").arg(QLocale().toString(error.max, 'f', 0))
                   : tr("\"%1\" has too many entries: at most %2 are read")
                         .arg(key, QLocale().toString(error.max, 'f', 0));
    case Kind::BadName:
        return tr("it refers to a file that is outside of its folder, or whose name is not allowed: %1").arg(key);
    default:
        return {};
    }
}

/// Returns the type that a key of lesson.json must have.
QString LessonMessages::wrongType(const std::string& key)
{
    const auto isAmong = [&key](std::initializer_list<const char*> keys) {
        return std::ranges::find(keys, key) != keys.end();
    };
    const QString shown = QString::fromStdString(key);
    if (isAmong({"title", "summary", "text"}))
        return tr("\"%1\" must contain texts by language, as in {\"en\": \"A mug\"}").arg(shown);
    if (key == "steps")
        return tr("\"%1\" must be a list of steps, as in [{…}, {…}]").arg(shown);
    if (key == "tools")
        return tr("\"%1\" must be a list of tools, as in [\"pull\", \"smooth\"]").arg(shown);
    if (key == "checkpoint")
        return tr("\"%1\" must contain goals, as in {\"height_mm\": {\"least\": 60}}").arg(shown);
    if (key == "view")
        return tr("\"%1\" must be angles, as in {\"yaw_deg\": 75, \"pitch_deg\": -25}").arg(shown);
    if (key == "target")
        return tr("\"%1\" must contain a distance, as in {\"tolerance_mm\": 2}").arg(shown);
    if (isAmong({"start", "file", "picture", "strokes"}))
        return tr("\"%1\" must be a name in quotation marks").arg(shown);
    const auto* const fact = std::ranges::find(core::factTable, key, &core::FactInfo::key);
    if (fact == std::end(core::factTable))
        return key == "version" ? tr("\"%1\" must be a whole number").arg(shown)
                                : tr("\"%1\" must be a number").arg(shown);
    if (fact == &core::info(core::Fact::PrintReady))
        return tr("\"%1\" must be true").arg(shown);
    return fact->isWhole
               ? tr("\"%1\" must be a whole number or a range, such as {\"least\": 1, \"most\": 2}").arg(shown)
               : tr("\"%1\" must be a number or a range, such as {\"least\": 1, \"most\": 2}").arg(shown);
}

/// Returns the reason for an error outside the text of lesson.json: a missing or bad file, or a command that would
/// break the model; empty for other errors.
QString LessonMessages::files(const core::LessonError& error)
{
    switch (error.kind) {
    case Kind::NoLesson:
        return tr("it has no lesson.json: a lesson is a folder or ZIP file that contains one");
    case Kind::MissingFile:
        return tr("this file is missing");
    case Kind::TooLarge:
        return tr("this is too large for a lesson: at most %1 are read").arg(bytes(error.max));
    case Kind::NotAPicture:
        return tr("this is not a PNG or JPEG picture");
    case Kind::Unsound:
        return error.report.printReady()
                   ? ui::ErrorMessages::tooFine(QString::fromStdString(error.file), static_cast<quint64>(error.max))
                   : ui::ErrorMessages::refusal(QString::fromStdString(error.file), error.report);
    case Kind::Strokes:
        return error.strokes ? ui::StrokeFileMessages::reason(*error.strokes) : QString();
    case Kind::NamesFiles:
        return tr("the strokes of a lesson cannot need other images or models");
    case Kind::Refused:
        return tr("this command would break the model that it is applied to");
    default:
        return {};
    }
}

QString LessonMessages::figure(core::Fact fact, double value)
{
    switch (fact) {
    case core::Fact::Height:
    case core::Fact::Width:
    case core::Fact::Depth:
    case core::Fact::Widest:
        return tr("%1 mm").arg(millimetres(value));
    case core::Fact::BaseArea:
        // always cm², so that small and large areas have the same unit
        return tr("%1 cm²").arg(QLocale().toString(value / 100, 'f', 1));
    case core::Fact::Volume:
        return ui::volumeText(std::abs(value));
    default:
        return QLocale().toString(value, 'f', 0);
    }
}

QString LessonMessages::quantity(const core::FactBounds& bounds)
{
    const QString min = figure(bounds.fact, bounds.min);
    if (bounds.min == bounds.max)
        return min;
    if (bounds.max == core::FactBounds::unbounded)
        return tr("at least %1").arg(min);
    const QString max = figure(bounds.fact, bounds.max);
    return bounds.min > 0 ? tr("%1 to %2", "from; to").arg(min, max) : tr("at most %1").arg(max);
}

QString LessonMessages::asked(const core::FactBounds& bounds)
{
    using core::Fact;
    const bool isOne = bounds.min == 1 && bounds.max == 1;
    const QString quantity = LessonMessages::quantity(bounds);
    switch (bounds.fact) {
    case Fact::Genus:
        return bounds.max == 0 ? tr("no holes") : isOne ? tr("one hole") : tr("holes: %1").arg(quantity);
    case Fact::Components:
        return isOne ? tr("in one piece") : tr("pieces: %1").arg(quantity);
    //: %1 as in "at least 60 mm", as in all that follow
    case Fact::Height:
        return tr("%1 tall").arg(quantity);
    case Fact::Width:
        return tr("%1 wide").arg(quantity);
    case Fact::Depth:
        return tr("%1 deep").arg(quantity);
    case Fact::Widest:
        return tr("%1 long, seen from above").arg(quantity);
    case Fact::Feet:
        return tr("legs on the ground: %1").arg(quantity);
    case Fact::BaseArea:
        return tr("flat base: %1").arg(quantity);
    case Fact::Grooves:
        return tr("narrow places all around: %1").arg(quantity);
    case Fact::Volume:
        return tr("%1 of clay").arg(quantity);
    case Fact::Faces:
        return tr("triangles: %1").arg(quantity);
    case Fact::PrintReady:
        break;
    }
    return tr("ready to print");
}

QString LessonMessages::goal(const core::FactVerdict& verdict)
{
    const QString asked = LessonMessages::asked(verdict.asked);
    if (!verdict.measured)
        return tr("%1 (cannot be said of this model)").arg(asked);
    if (verdict.holds && verdict.asked.min == verdict.asked.max)
        return asked;
    if (verdict.asked.fact == core::Fact::PrintReady)
        return tr("%1 (not yet)").arg(asked);
    return tr("%1 (now %2)").arg(asked, figure(verdict.asked.fact, *verdict.measured));
}

QString LessonMessages::asked(const core::CheckpointTarget& target)
{
    return tr("like the teacher's to %1 mm").arg(millimetres(target.tolerance));
}

QString LessonMessages::sculpted()
{
    return tr("something sculpted in this step");
}

QString LessonMessages::tool(core::Tool tool)
{
    return StrokeStep::textOf(tool);
}

QString LessonMessages::brush(const core::LessonBrush& brush)
{
    const QString its = tool(brush.tool), radius = millimetres(brush.radius);
    //: a tool and its radius
    return brush.strength == 1 ? tr("%1 %2 mm").arg(its, radius)
                               : tr("%1 %2 mm (strength %3)").arg(its, radius, QLocale().toString(brush.strength));
}

QString LessonMessages::goal(const core::TargetVerdict& verdict)
{
    return tr("like the teacher's to %1 mm (now up to %2)")
        .arg(millimetres(verdict.tolerance), millimetres(verdict.nearDistance));
}
} // namespace app
