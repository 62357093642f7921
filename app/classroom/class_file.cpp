// QSettings is not used: it accepts any file, reports no line numbers, and interprets \ and , in folder names.

#include "app/classroom/class_file.h"

#include "app/classroom/class_pin.h"
#include "app/lesson/lesson_messages.h"
#include "app/lesson/lesson_model.h"

#include "core/util/atomic_file.h"
#include "ui/settings/stored_values.h"
#include "ui/util/error_messages.h"

#include <QDir>
#include <QFileInfo>
#include <QHash>
#include <QStringDecoder>

#include <algorithm>

namespace app
{
namespace
{
constexpr qint64 maxBytes = 64 << 10;
constexpr QChar nameSeparator = u';'; // a comma may be part of a name

struct Entry
{
    int line = 0;
    QString value;
};

[[noreturn]] void fail(const QString& sentence)
{
    throw ClassFileError{sentence};
}

QString bytesToText(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        fail(ClassFile::tr("%1 cannot be read (%2).").arg(QDir::toNativeSeparators(path), file.errorString()));
    QStringDecoder decoder(QStringDecoder::Utf8);
    const QByteArray bytes = file.read(maxBytes + 1);
    const QString text = decoder(bytes);
    if (bytes.size() > maxBytes || decoder.hasError() || text.contains(QChar::Null))
        fail(ClassFile::tr("%1 is not a class file: it is not UTF-8 text, or it is too long.")
                 .arg(QDir::toNativeSeparators(path)));
    return text;
}

/// Returns the allowed words as text for an error message.
QString wordList(const QStringList& words)
{
    return words.join(QStringLiteral(", "));
}

QStringList toolWords()
{
    QStringList words;
    for (const std::string_view name : core::toolNames())
        words << QString::fromUtf8(name);
    return words;
}

QStringList starterWords()
{
    QStringList words;
    for (const core::Starter starter : core::starters)
        words << QString::fromUtf8(core::name(starter));
    return words;
}

template <class T, std::size_t count> QStringList wordsOf(const std::array<ui::Named<T>, count>& rows)
{
    QStringList words;
    for (const ui::Named<T>& row : rows)
        words << QLatin1StringView(row.key);
    return words;
}

QString noPin()
{
    return ClassFile::tr("this is not a PIN as Fettle writes it; set one with Edit › Classroom.");
}

/// Returns an absolute path. A relative path is resolved against the folder of the class file.
QString pathFrom(const QString& classFile, const QString& path)
{
    return QDir::cleanPath(QFileInfo(classFile).absoluteDir().absoluteFilePath(QDir::fromNativeSeparators(path)));
}

/// Parses a class file. Each value is removed from m_entries when it is read, so that unknown keys remain.
class Reader
{
public:
    explicit Reader(const QString& path) : m_path(path)
    {
        int number = 0;
        for (const QString& line : bytesToText(path).split(u'\n'))
            takeLine(++number, line.trimmed());
    }

    ui::Classroom classroom()
    {
        ui::Classroom read;
        read.title = text("title");
        read.folder = pathFrom(m_path, text("folder"));
        const bool hasLesson = m_entries.contains(QStringLiteral("lesson"));
        if (!hasLesson || m_entries.contains(QStringLiteral("starters")))
            for (const qsizetype i : choices("starters", starterWords()))
                read.starters << core::starters[i];
        for (const qsizetype i : choices("tools", toolWords()))
            read.tools << static_cast<core::Tool>(i);
        if (hasLesson) {
            const QString lesson = text("lesson");
            read.lesson = bundledLessons().contains(lesson) ? lesson : pathFrom(m_path, lesson);
            const QString problem = ClassFile::lessonProblem(read);
            if (!problem.isEmpty())
                failAt("lesson", problem);
        }
        read.turnMinutes = minutes("turn_minutes", read.turnMinutes, ui::maxTurnMinutes);
        const int max = read.turnMinutes;
        read.warningMinutes = minutes("warning_minutes", std::min(read.warningMinutes, max), max);
        read.fullScreen = choice("full_screen", {QStringLiteral("yes"), QStringLiteral("no")}) == 0;
        read.language = ui::languages[static_cast<std::size_t>(choice("language", wordsOf(ui::languages)))].value;
        read.asksQuestions = choice("questions", {QStringLiteral("no"), QStringLiteral("yes")}) == 1;
        read.names = names();
        read.allowsOthers = allowsOthers(read.names);
        read.pin = text("pin");
        if (!isPinRecord(read.pin))
            failAt("pin", noPin());
        if (!m_entries.isEmpty())
            failUnknown();
        return read;
    }

private:
    void takeLine(int number, const QString& line)
    {
        if (line.isEmpty() || line.startsWith(u'#') || line.startsWith(u';') || line.startsWith(u'['))
            return;
        const qsizetype equals = line.indexOf(u'=');
        const QString key = line.left(equals).trimmed();
        if (equals <= 0)
            failIn(number, ClassFile::tr("each line must be key = value, or begin with #."));
        if (m_entries.contains(key))
            failIn(number, ClassFile::tr("%1 appears twice.").arg(key));
        m_entries.insert(key, {number, line.mid(equals + 1).trimmed()});
    }

    /// Returns the value and removes its entry; empty if the key is missing.
    QString takeValue(const char* key)
    {
        const Entry entry = m_entries.take(QLatin1StringView(key));
        m_line = entry.line;
        return entry.value;
    }

    QString text(const char* key)
    {
        const QString value = takeValue(key);
        if (m_line == 0)
            fail(ClassFile::tr("%1: %2 is missing.").arg(QDir::toNativeSeparators(m_path), QLatin1StringView(key)));
        if (value.isEmpty())
            failAt(key, ClassFile::tr("it is empty."));
        return value;
    }

    QStringList names()
    {
        QStringList names;
        for (const QString& part : takeValue("names").split(nameSeparator)) {
            const QString name = part.simplified();
            if (name.isEmpty())
                continue;
            if (name.size() > ui::maxPupilNameLength || names.size() == ui::maxPupilNames)
                failAt("names", ClassFile::tr("at most %1 names of at most %2 characters.")
                                    .arg(ui::maxPupilNames)
                                    .arg(ui::maxPupilNameLength));
            if (names.contains(name))
                failAt("names", ClassFile::tr("%1 appears twice.").arg(name));
            names << name;
        }
        return names;
    }

    bool allowsOthers(const QStringList& names)
    {
        const bool allows = choice("other_names", {QStringLiteral("yes"), QStringLiteral("no")}) == 0;
        if (!allows && names.isEmpty())
            failAt("other_names", ClassFile::tr("there are no names to choose from."));
        return allows;
    }

    int minutes(const char* key, int otherwise, int max)
    {
        const QString value = takeValue(key);
        bool isNumber = false;
        const int number = value.toInt(&isNumber);
        if (m_line == 0)
            return otherwise;
        if (!isNumber || number < 0 || number > max)
            failAt(key,
                   ClassFile::tr("must be a whole number from 0 to %2, not \"%1\".").arg(value, QString::number(max)));
        return number;
    }

    qsizetype indexOf(const char* key, const QString& word, const QStringList& words) const
    {
        const qsizetype index = words.indexOf(word);
        if (index < 0)
            failAt(key, ClassFile::tr("\"%1\" is none of %2.").arg(word, wordList(words)));
        return index;
    }

    /// Returns the index of the chosen word; 0 if the key is missing.
    qsizetype choice(const char* key, const QStringList& words)
    {
        const QString value = takeValue(key);
        return m_line == 0 ? 0 : indexOf(key, value, words);
    }

    QList<qsizetype> choices(const char* key, const QStringList& words)
    {
        QList<qsizetype> chosen;
        for (const QString& word : text(key).split(u',')) {
            chosen << indexOf(key, word.trimmed(), words);
            if (chosen.count(chosen.last()) > 1)
                failAt(key, ClassFile::tr("%1 appears twice.").arg(word.trimmed()));
        }
        return chosen;
    }

    void failUnknown() const
    {
        const auto first = std::min_element(m_entries.begin(), m_entries.end(),
                                            [](const Entry& a, const Entry& b) { return a.line < b.line; });
        failIn(first->line, ClassFile::tr("%1 is not a key of a class file.").arg(first.key()));
    }

    [[noreturn]] void failIn(int line, const QString& reason) const
    {
        fail(ClassFile::tr("%1, line %2: %3").arg(QDir::toNativeSeparators(m_path), QString::number(line), reason));
    }
    [[noreturn]] void failAt(const char* key, const QString& reason) const
    {
        failIn(m_line, QStringLiteral("%1: %2").arg(QLatin1StringView(key), reason));
    }

    QString m_path;
    QHash<QString, Entry> m_entries; ///< entries not read yet
    int m_line = 0;                  ///< line of the key read last; 0: the key is missing
};

QString textOf(const ui::Classroom& classroom)
{
    QStringList starters, tools;
    for (const core::Starter starter : classroom.starters)
        starters << QString::fromUtf8(core::name(starter));
    for (const core::Tool tool : classroom.tools)
        tools << QString::fromUtf8(core::name(tool));
    QList<std::pair<const char*, QString>> lines{
        {"title", classroom.title},
        {"folder", QDir::toNativeSeparators(classroom.folder)},
        {"tools", wordList(tools)},
        {"turn_minutes", QString::number(classroom.turnMinutes)},
        {"warning_minutes", QString::number(classroom.warningMinutes)},
        {"full_screen", classroom.fullScreen ? QStringLiteral("yes") : QStringLiteral("no")},
        {"questions", classroom.asksQuestions ? QStringLiteral("yes") : QStringLiteral("no")},
        {"language", ui::stored::wordFor(classroom.language, ui::languages)},
        {"pin", classroom.pin}};
    if (!starters.isEmpty())
        lines << std::pair("starters", wordList(starters));
    if (!classroom.lesson.isEmpty())
        lines << std::pair("lesson", QDir::toNativeSeparators(classroom.lesson));
    if (!classroom.names.isEmpty())
        lines << std::pair("names", classroom.names.join(nameSeparator + u' '))
              << std::pair("other_names", classroom.allowsOthers ? QStringLiteral("yes") : QStringLiteral("no"));
    QString text =
        ClassFile::tr("# A class for Fettle. It begins with: fettle --classroom and the name of this file.") + u'\n';
    for (const auto& [key, value] : lines)
        text += QStringLiteral("%1 = %2\n").arg(QLatin1StringView(key), value);
    return text;
}
} // namespace

ui::Classroom ClassFile::read(const QString& path)
{
    return Reader(path).classroom();
}

QString ClassFile::write(const QString& path, const ui::Classroom& classroom)
{
    try {
        core::AtomicFile file(toPath(path));
        file.write(textOf(classroom).toUtf8().toStdString());
        file.commit();
    } catch (const core::FileError& error) {
        return ui::ErrorMessages::sentence(error);
    }
    return {};
}

QString ClassFile::lessonProblem(const ui::Classroom& classroom)
{
    if (classroom.lesson.isEmpty())
        return {};
    if (!bundledLessons().contains(classroom.lesson) && !QFileInfo::exists(classroom.lesson))
        return tr("%1 is not a lesson: it is neither one of %2 nor a folder or ZIP file.")
            .arg(QDir::toNativeSeparators(classroom.lesson), wordList(bundledLessons()));
    const ReadLesson read = tryToReadLesson(classroom.lesson, readLessonOfClass);
    if (!read.lesson)
        return read.problem;
    for (std::size_t i = 0; i < read.lesson->steps.size(); ++i)
        for (const core::Tool tool : read.lesson->steps[i].tools)
            if (!classroom.tools.contains(tool))
                return tr("Step %1 of the lesson needs the tool %2 (%3), which is not among the class's tools.")
                    .arg(QString::number(i + 1), LessonMessages::tool(tool), QString::fromUtf8(core::name(tool)));
    return {};
}
} // namespace app
