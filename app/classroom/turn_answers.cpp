#include "app/classroom/turn_answers.h"

#include "app/model/model_loader.h"

#include "core/util/atomic_file.h"
#include "ui/util/error_messages.h"

#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>

#include <cmath>

namespace app
{
namespace
{
constexpr int answersVersion = 1;
constexpr qint64 maxAnswersBytes = 64 << 10;
const QString answersFormatKey = QStringLiteral("format"), answersFormat = QStringLiteral("fettle-answers"),
              answersVersionKey = QStringLiteral("version"), answersIdKey = QStringLiteral("id"),
              answersKey = QStringLiteral("answers");

/// Keys in the file, in the order of ui::Question.
const std::array<QString, ui::questionCount> answerKeys{QStringLiteral("mastering"), QStringLiteral("functions"),
                                                        QStringLiteral("errors"),    QStringLiteral("details"),
                                                        QStringLiteral("topology"),  QStringLiteral("overall")};

std::optional<int> answerOf(const QJsonValue& value)
{
    const double number = value.toDouble(0); // 0 if the value is not a number
    const bool isAnswer = number >= ui::minAnswer && number <= ui::maxAnswer && number == std::floor(number);
    return isAnswer ? std::optional(static_cast<int>(number)) : std::nullopt;
}
} // namespace

const QString TurnAnswers::fileName = QStringLiteral("answers.json");

TurnAnswers TurnAnswers::read(const QString& folder)
{
    TurnAnswers read;
    const QFileInfo info(folder + u'/' + fileName);
    if (!info.isFile()) { // opening a pipe would block
        if (info.exists())
            read.problem = ui::ErrorMessages::sentence({core::FileErrorKind::NotAFile, toPath(fileName)});
        else if (info.isSymLink())
            read.problem = tr("%1 is a link to a file that is not there.").arg(fileName);
        return read;
    }
    QFile file(info.filePath());
    const QByteArray bytes = file.open(QIODevice::ReadOnly) ? file.read(maxAnswersBytes + 1) : QByteArray();
    const QJsonObject whole = QJsonDocument::fromJson(bytes).object();
    const double version = whole.value(answersVersionKey).toDouble(0); // 0 if the value is not a number
    const bool isRead = bytes.size() <= maxAnswersBytes && whole.value(answersFormatKey) == answersFormat;
    if (isRead && version > answersVersion) {
        read.problem = tr("%1 was made by a newer version of Fettle.").arg(fileName);
        return read;
    }
    if (!isRead || version != answersVersion || !whole.value(answersKey).isObject()) {
        read.problem = tr("%1 contains no answers that can be read.").arg(fileName);
        return read;
    }
    read.turnId = whole.value(answersIdKey).toString();
    const QJsonObject answers = whole.value(answersKey).toObject();
    for (std::size_t i = 0; i < ui::questionCount; ++i) {
        const QJsonValue value = answers.value(answerKeys[i]);
        read.questionnaire.answers[i] = answerOf(value);
        if (!value.isUndefined() && !read.questionnaire.answers[i] && read.problem.isEmpty())
            read.problem =
                tr("%1: the answer \"%2\" is left out, because it is not a whole number from %3 to %4.")
                    .arg(fileName, answerKeys[i], QString::number(ui::minAnswer), QString::number(ui::maxAnswer));
    }
    return read;
}

QString TurnAnswers::write(const QString& folder) const
{
    const QString path = folder + u'/' + fileName;
    QJsonObject answers;
    for (std::size_t i = 0; i < ui::questionCount; ++i)
        if (questionnaire.answers[i])
            answers.insert(answerKeys[i], *questionnaire.answers[i]);
    try {
        if (answers.isEmpty()) {
            std::error_code failure; // not set if the file does not exist
            std::filesystem::remove(toPath(path), failure);
            core::checkWritten(failure, toPath(path));
            return {};
        }
        core::AtomicFile file(toPath(path));
        file.write(QJsonDocument(QJsonObject{{answersFormatKey, answersFormat},
                                             {answersVersionKey, answersVersion},
                                             {answersIdKey, turnId},
                                             {answersKey, answers}})
                       .toJson()
                       .toStdString());
        file.commit();
    } catch (const core::FileError& error) {
        return ui::ErrorMessages::sentence(error);
    }
    return {};
}
} // namespace app
