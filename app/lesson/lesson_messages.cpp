#include "app/lesson/lesson_messages.h"

#include "ui/util/error_messages.h"
#include "ui/util/stroke_file_messages.h"

#include <QDir>
#include <QLocale>

namespace app
{
namespace
{
using Kind = core::LessonError::Kind;

QString bytes(double count)
{
    return QLocale().formattedDataSize(static_cast<qint64>(count));
}

QString millimetres(double length)
{
    return QLocale().toString(length, 'f', length < 10 ? 2 : 1);
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

/// Of what lesson.json says.
QString LessonMessages::json(const core::LessonError& error)
{
    const QString key = QString::fromStdString(error.key);
    switch (error.kind) {
    case Kind::NotALesson:
        return tr("its lesson.json is no lesson of this program");
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
        return tr("\"%1\" is of the wrong type, or holds nothing that a lesson can use").arg(key);
    case Kind::UnknownValue:
        return tr("unknown value, %1").arg(key);
    case Kind::OutOfRange:
        return tr("\"%1\" is out of range, %2 to %3")
            .arg(key, QString::number(error.min, 'g', 6), QString::number(error.max, 'g', 6));
    case Kind::NoWords:
        return tr("\"%1\" has no words in some language").arg(key);
    case Kind::TooLong:
        return tr("\"%1\" is too long: at most %2 of text are read").arg(key, bytes(error.max));
    case Kind::TooMany:
        return key.isEmpty()
                   ? tr("it holds too many files: at most %1 are read").arg(QLocale().toString(error.max, 'f', 0))
                   : tr("\"%1\" has too many entries: at most %2 are read")
                         .arg(key, QLocale().toString(error.max, 'f', 0));
    case Kind::BadName:
        return tr("it names a file outside of its folder, or by no plain name: %1").arg(key);
    default:
        return {};
    }
}

/// Of what it names.
QString LessonMessages::files(const core::LessonError& error)
{
    switch (error.kind) {
    case Kind::NoLesson:
        return tr("there is no lesson.json in it: a lesson is a folder or a zip with that file");
    case Kind::MissingFile:
        return tr("this file is named, but not there");
    case Kind::TooLarge:
        return tr("this is too large for a lesson: at most %1 are read").arg(bytes(error.max));
    case Kind::NotAPicture:
        return tr("this is no PNG or JPEG picture");
    case Kind::Unsound:
        return error.report.printReady()
                   ? ui::ErrorMessages::tooFine(QString::fromStdString(error.file), static_cast<quint64>(error.max))
                   : ui::ErrorMessages::refusal(QString::fromStdString(error.file), error.report);
    case Kind::Strokes:
        return error.strokes ? ui::StrokeFileMessages::reason(*error.strokes) : QString();
    case Kind::NamesFiles:
        return tr("the strokes of a lesson cannot need other images or models");
    case Kind::Refused:
        return tr("this command cannot be done soundly on the model that it comes to");
    default:
        return {};
    }
}

QString LessonMessages::name(core::Fact fact)
{
    const QString names[] = {tr("holes"), tr("parts"),  tr("height"),    tr("width"),
                             tr("depth"), tr("volume"), tr("triangles"), tr("ready to print")};
    static_assert(std::size(names) == static_cast<std::size_t>(core::Fact::PrintReady) + 1);
    return names[static_cast<std::size_t>(fact)];
}

QString LessonMessages::figure(core::Fact fact, double value)
{
    switch (fact) {
    case core::Fact::Height:
    case core::Fact::Width:
    case core::Fact::Depth:
        return tr("%1 mm").arg(millimetres(value));
    case core::Fact::Volume:
        return tr("%1 mm³").arg(QLocale().toString(value, 'f', 0));
    case core::Fact::PrintReady:
        return value > 0 ? tr("yes") : tr("no");
    default:
        return QLocale().toString(value, 'f', 0);
    }
}

QString LessonMessages::asked(const core::FactBounds& bounds)
{
    const QString min = figure(bounds.fact, bounds.min);
    if (bounds.min == bounds.max)
        return tr("%1: %2", "a fact: its value").arg(name(bounds.fact), min);
    if (bounds.max == core::FactBounds::unbounded)
        return tr("%1: at least %2").arg(name(bounds.fact), min);
    const QString max = figure(bounds.fact, bounds.max);
    return bounds.min > 0 ? tr("%1: %2 to %3").arg(name(bounds.fact), min, max)
                          : tr("%1: at most %2").arg(name(bounds.fact), max);
}

QString LessonMessages::asked(const core::CheckpointTarget& target)
{
    return tr("shape: within %1 mm of the teacher's").arg(millimetres(target.tolerance));
}

QString LessonMessages::found(const core::FactVerdict& verdict)
{
    return verdict.measured ? figure(verdict.asked.fact, *verdict.measured) : tr("cannot be said of this model");
}

QString LessonMessages::found(const core::TargetVerdict& verdict)
{
    return tr("%1 mm apart, at most %2 mm").arg(millimetres(verdict.nearDistance), millimetres(verdict.largest));
}
} // namespace app
