#include "ui/util/stroke_file_messages.h"

#include "core/util/system_code.h"

#include <QLocale>

namespace ui
{
namespace
{
/// Returns six significant digits, enough to show on which side of a limit the value is.
QString number(double value)
{
    return QString::number(value, 'g', 6);
}

QString joined(const std::vector<std::string>& words)
{
    QStringList list;
    for (const std::string& word : words)
        list << QString::fromStdString(word);
    return list.join(QStringLiteral(", "));
}
} // namespace

QString StrokeFileMessages::sentence(const QString& path, const core::StrokeFileError& error)
{
    const QString where = place(error);
    return where.isEmpty() ? tr("%1: %2", "file: reason").arg(path, reason(error))
                           : tr("%1: %2: %3", "file: place: reason").arg(path, where, reason(error));
}

QString StrokeFileMessages::place(const core::StrokeFileError& error)
{
    QStringList places;
    if (error.line > 0)
        places << tr("line %1, byte %2").arg(error.line).arg(error.byte);
    if (error.stroke && error.sample)
        //: counted from 1; in brackets as in the file, counted from 0
        places << tr("stroke %1, sample %2 (strokes[%3].samples[%4])")
                      .arg(*error.stroke + 1)
                      .arg(*error.sample + 1)
                      .arg(*error.stroke)
                      .arg(*error.sample);
    else if (error.stroke)
        places << tr("stroke %1 (strokes[%2])").arg(*error.stroke + 1).arg(*error.stroke);
    return places.join(QStringLiteral(", "));
}

QString StrokeFileMessages::reason(const core::StrokeFileError& error)
{
    using Kind = core::StrokeFileError::Kind;
    const QString key = QString::fromStdString(error.key);
    switch (error.kind) {
    case Kind::CannotRead:
        if (error.systemError == 0)
            return tr("this file cannot be read");
        return core::isSystemCode(error.systemError, std::errc::no_such_file_or_directory)
                   ? tr("there is no such file")
                   : tr("this file cannot be read (%1)").arg(qt_error_string(error.systemError));
    case Kind::TooLarge:
        return tr("this file is too large: at most %1 are read")
            .arg(QLocale().formattedDataSize(static_cast<qint64>(error.max.value_or(0))));
    case Kind::Syntax:
        return tr("this is not JSON");
    case Kind::DuplicateKey:
        return tr("\"%1\" appears twice").arg(key);
    case Kind::NotStrokes:
        if (error.version)
            return tr("it has version %1; this program reads version 1").arg(number(*error.version));
        return tr("this is not a stroke file of version 1 (%1)").arg(key.isEmpty() ? tr("no object") : key);
    case Kind::NotBrush:
        return tr("this is not a brush preset of version 1 (%1)").arg(key.isEmpty() ? tr("no object") : key);
    case Kind::NewerVersion:
        return tr("this brush preset was made by a newer version of Fettle");
    case Kind::UnknownKey:
        return tr("unknown key %1").arg(key);
    case Kind::MissingKey:
        return tr("\"%1\" is missing").arg(key);
    case Kind::WrongType:
        return wrongType(key, error.wanted.value_or(core::StrokeFileError::Value::Word));
    case Kind::UnknownValue:
        return error.words.empty() ? tr("unknown value, %1").arg(key)
                                   //: key and value, as in place: "there"
                                   : tr("%1 is none of %2").arg(key, joined(error.words));
    case Kind::NotANumber:
        return tr("\"%1\" is not a finite number").arg(key);
    case Kind::OutOfRange:
        if (error.min && error.max && error.orZero)
            return tr("\"%1\" is out of range, 0 or %2 to %3").arg(key, number(*error.min), number(*error.max));
        if (error.min && error.max)
            return tr("\"%1\" is out of range, %2 to %3").arg(key, number(*error.min), number(*error.max));
        return tr("\"%1\" is out of range").arg(key);
    }
    return {};
}

QString StrokeFileMessages::wrongType(const QString& key, core::StrokeFileError::Value wanted)
{
    using Value = core::StrokeFileError::Value;
    switch (wanted) {
    case Value::Number:
        return tr("\"%1\" must be a number").arg(key);
    case Value::WholeNumber:
        return tr("\"%1\" must be a whole number").arg(key);
    case Value::ThreeNumbers:
        return tr("\"%1\" must be three numbers, as in [0, 1, 0]").arg(key);
    case Value::FourNumbers:
        return tr("\"%1\" must be four numbers, as in [0, 0, 0, 1]").arg(key);
    case Value::ThreeBytes:
        return tr("\"%1\" must be three whole numbers from 0 to 255, as in [200, 120, 80]").arg(key);
    case Value::WholeNumbers:
        return tr("\"%1\" must be a list of whole numbers, as in [0, 2]").arg(key);
    case Value::Pairs:
        return tr("\"%1\" must be a list of pairs of numbers, as in [[10, 0], [8, 20]]").arg(key);
    case Value::Triples:
        return tr("\"%1\" must be a list of points of three numbers, as in [[0, 0, 5], [9, 0, 5], [0, 9, 5]]").arg(key);
    case Value::Quadruples:
        return tr("\"%1\" must be a list of points of four numbers, as in [[0, 0, 0, 2], [9, 0, 0, 1]]").arg(key);
    case Value::TrueOrFalse:
        return tr("\"%1\" must be true or false").arg(key);
    case Value::Word:
        return tr("\"%1\" must be a word in quotation marks").arg(key);
    case Value::WordOrTruth:
        return tr("\"%1\" must be a word in quotation marks, true or false").arg(key);
    case Value::Object:
        return tr("\"%1\" must be an object in braces").arg(key);
    case Value::Objects:
        return tr("\"%1\" must be a list of objects, as in [{…}, {…}]").arg(key);
    }
    return {};
}
} // namespace ui
