// A work is written to a hidden folder, each file flushed to disk; then the folder is renamed. A visible folder thus
// contains a complete work.

#include "app/classroom/work_archive.h"

#include "app/model/model_loader.h"

#include "core/drawing/model_thumbnail.h"
#include "core/io/mesh_io.h"
#include "core/io/placed_mesh.h"
#include "core/util/atomic_file.h"
#include "ui/util/error_messages.h"
#include "ui/util/path_display.h"

#include <QBuffer>
#include <QDir>
#include <QFileInfo>
#include <QImage>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSysInfo>
#include <QUuid>

#include <algorithm>
#include <new>
#include <sstream>

namespace app
{
namespace
{
constexpr int pictureSize = 512;  ///< width and height, pixels
constexpr int maxNameLength = 40; ///< characters of the nickname used in a folder name
constexpr int maxNumber = 10'000;
constexpr int staleHours = 24;
constexpr qint64 maxTurnBytes = 64 << 10; ///< largest size of turn.json that is read, bytes
const QString unfinished = QStringLiteral(".unfinished-");
const QString turnFile = QStringLiteral("turn.json"), modelFile = QStringLiteral("model.glb");
const QString turnIdKey = QStringLiteral("id"), turnNameKey = QStringLiteral("name"),
              turnBegunKey = QStringLiteral("begun"), turnEndedKey = QStringLiteral("ended"),
              turnLessonKey = QStringLiteral("lesson"), turnUsedKey = QStringLiteral("used_seconds");
constexpr qint64 msPerSecond = 1000;

void writeFile(const QString& path, const QByteArray& bytes)
{
    core::AtomicFile file(toPath(path));
    file.write({bytes.constData(), static_cast<std::size_t>(bytes.size())});
    file.commit();
}

QByteArray readFile(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        throw core::FileError(core::FileErrorKind::NotReadable, toPath(path));
    return file.readAll();
}

QByteArray pictureOf(const core::TriangleMesh& mesh)
{
    const auto picture = core::drawThumbnail(mesh, pictureSize, {});
    QByteArray png;
    if (!picture || picture->rgba.empty())
        return png;
    const QImage image(reinterpret_cast<const uchar*>(picture->rgba.data()), picture->width, picture->height,
                       QImage::Format_RGBA8888_Premultiplied);
    QBuffer buffer(&png);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return png;
}

QByteArray recordOf(const std::vector<core::FileEntry>& entries)
{
    std::ostringstream text;
    core::writeStrokes(text, entries);
    return QByteArray::fromStdString(text.str());
}

QByteArray turnOf(const TurnWork& work)
{
    QJsonObject turn{{QStringLiteral("format"), QStringLiteral("fettle-turn")},
                     {QStringLiteral("version"), 1},
                     {turnIdKey, work.id},
                     {turnNameKey, work.pupil},
                     {turnEndedKey, work.ended.toString(Qt::ISODate)},
                     {QStringLiteral("steps"), work.steps},
                     {QStringLiteral("computer"), QSysInfo::machineHostName()},
                     {QStringLiteral("mesh_hash"), QStringLiteral("%1").arg(work.meshHash, 16, 16, QLatin1Char('0'))}};
    if (work.begun.isValid())
        turn.insert(turnBegunKey, work.begun.toString(Qt::ISODate));
    if (work.usedMs)
        turn.insert(turnUsedKey, *work.usedMs / msPerSecond);
    if (work.lesson)
        turn.insert(turnLessonKey, work.lesson->toJson());
    return QJsonDocument(turn).toJson();
}

QString idIn(const QByteArray& turn)
{
    return QJsonDocument::fromJson(turn).object().value(turnIdKey).toString();
}

void writeWork(const QString& folder, const TurnWork& work)
{
    const std::filesystem::path model = toPath(WorkArchive::modelOf(folder));
    core::writeMesh(model, core::placedMesh(model, *work.mesh, work.metadata.place()), {.metadata = work.metadata});
    writeFile(folder + QStringLiteral("/picture.png"), pictureOf(*work.mesh));
    if (work.record)
        writeFile(folder + QStringLiteral("/record.json"), recordOf(*work.record));
    writeFile(folder + u'/' + turnFile, turnOf(work));
}

void copyWork(const QString& from, const QString& to)
{
    for (const QString& name : QDir(from).entryList(QDir::Files))
        writeFile(to + u'/' + name, readFile(from + u'/' + name));
}

/// A hidden folder that is being filled. It is deleted with its content unless renameTo() succeeds.
class HiddenFolder
{
public:
    explicit HiddenFolder(const QString& root)
        : m_root(root)
        , m_path(root + u'/' + unfinished + QUuid::createUuid().toString(QUuid::WithoutBraces))
    {
        std::error_code problem;
        std::filesystem::create_directory(toPath(m_path), problem);
        core::checkWritten(problem, toPath(m_path));
    }
    ~HiddenFolder()
    {
        if (!m_path.isEmpty())
            QDir(m_path).removeRecursively();
    }
    Q_DISABLE_COPY_MOVE(HiddenFolder)

    const QString& path() const { return m_path; }

    /// Renames the folder to `name`, or to `name` with the first free number. Returns the new path.
    QString renameTo(const QString& name)
    {
        for (int number = 1; number < maxNumber; ++number) {
            const QString path = m_root + u'/' + numbered(name, number);
            if (!QFileInfo::exists(path) && core::renameFolder(toPath(m_path), toPath(path))) {
                m_path.clear();
                return path;
            }
        }
        throw core::FileError(core::FileErrorKind::WriteFailed, toPath(m_root + u'/' + name));
    }

    static QString numbered(const QString& name, int number)
    {
        return number == 1 ? name : QStringLiteral("%1-%2").arg(name).arg(number);
    }

private:
    QString m_root, m_path;
};

/// Makes a folder called `name`, filled by `fill` while it is hidden. Errors name the final folder instead of the
/// hidden one.
template <class Fill> QString makeFolder(const QString& root, const QString& name, Fill fill)
{
    try {
        HiddenFolder folder(root);
        fill(folder.path());
        return folder.renameTo(name);
    } catch (core::FileError& error) {
        error.path = toPath(root + u'/' + name);
        throw;
    }
}

ArchivedWork addTo(const QString& root, const QString& name, const TurnWork& work)
{
    try {
        return {makeFolder(root, name, [&work](const QString& folder) { writeWork(folder, work); }), {}};
    } catch (const core::FileError& error) {
        return {{}, ui::ErrorMessages::sentence(error)};
    } catch (const std::bad_alloc&) {
        return {{}, WorkArchive::tr("%1: there is not enough memory to write this model.").arg(root)};
    }
}

/// Returns the folder called `name`, perhaps with a number, whose turn.json is accepted by `isTurn`; empty: none.
template <class IsTurn> QString findWork(const QString& root, const QString& name, IsTurn isTurn)
{
    for (int number = 1; number < maxNumber; ++number) {
        const QString folder = root + u'/' + HiddenFolder::numbered(name, number);
        if (!QFileInfo::exists(folder))
            break;
        QFile file(folder + u'/' + turnFile);
        if (file.open(QIODevice::ReadOnly) && isTurn(file.readAll()))
            return folder;
    }
    return {};
}

/// Deletes a work. It is renamed to a hidden name first, so that an interrupted deletion leaves no incomplete work.
void removeWork(const QString& root, const QString& name)
{
    const QString hidden = root + u'/' + unfinished + name;
    if (QDir().rename(root + u'/' + name, hidden))
        QDir(hidden).removeRecursively();
}

/// Copies or deletes the answers of a work that was delivered before its answers were changed.
void bringAnswers(const QString& from, const QString& to)
{
    if (QFileInfo::exists(from)) {
        writeFile(to, readFile(from));
        return;
    }
    std::error_code problem; // not set if the file does not exist
    std::filesystem::remove(toPath(to), problem);
    core::checkWritten(problem, toPath(to));
}

/// Copies a work of the outbox to `folder`. Returns the folder of the copy.
QString copyOne(const QString& outbox, const QString& folder, const QString& name)
{
    const QString from = outbox + u'/' + name;
    QString to = findWork(folder, name,
                          [turn = readFile(from + u'/' + turnFile)](const QByteArray& other) { return other == turn; });
    if (to.isEmpty())
        to = makeFolder(folder, name, [&from](const QString& hidden) { copyWork(from, hidden); });
    else
        bringAnswers(from + u'/' + TurnAnswers::fileName, to + u'/' + TurnAnswers::fileName);
    return to;
}

/// Calls `handle` with the name of each work in the outbox, until paused. `handle` returns the folder of the result.
template <class Handle>
Delivery forEachWork(const QString& outbox, const std::function<bool()>& isPaused, Handle handle)
{
    Delivery delivery;
    for (const QString& name : QDir(outbox).entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name)) {
        if (isPaused && isPaused()) {
            delivery.isPaused = true;
            break;
        }
        try {
            delivery.moved.insert(outbox + u'/' + name, handle(name));
        } catch (const core::FileError& error) {
            ++delivery.undelivered;
            if (delivery.problem.isEmpty())
                delivery.problem = ui::ErrorMessages::sentence(error);
        }
    }
    return delivery;
}

bool isAllowedInName(char32_t c)
{
    return QChar::isLetterOrNumber(c) || QChar::isMark(c) || QChar::category(c) == QChar::Symbol_Other || c == U'-' ||
           c == U'_';
}
} // namespace

QString WorkArchive::folderName(const QDateTime& begun, const QString& pupil)
{
    QString name;
    int length = 0;
    for (const char32_t c : pupil.normalized(QString::NormalizationForm_C).simplified().toUcs4()) {
        const char32_t sign = c == U' ' ? U'-' : c;
        if (isAllowedInName(sign) && length++ < maxNameLength)
            name += QString::fromUcs4(&sign, 1);
    }
    if (name.isEmpty())
        name = QStringLiteral("unnamed");
    return begun.toString(QStringLiteral("yyyy-MM-dd-HHmm-")) + name;
}

ArchivedWork WorkArchive::add(const TurnWork& work) const
{
    const QString name = folderName(work.begun.isValid() ? work.begun : work.ended, work.pupil);
    QDir().mkpath(m_outbox);
    const ArchivedWork here = addTo(m_outbox, name, work);
    if (here.problem.isEmpty())
        return here;
    const ArchivedWork there = addTo(m_classFolder, name, work);
    return there.problem.isEmpty() ? there : here;
}

Delivery WorkArchive::deliver(const std::function<bool()>& isPaused) const
{
    return forEachWork(m_outbox, isPaused, [this](const QString& name) {
        const QString to = copyOne(m_outbox, m_classFolder, name);
        removeWork(m_outbox, name);
        return to;
    });
}

Delivery WorkArchive::copy(const QString& folder) const
{
    return forEachWork(m_outbox, {}, [this, &folder](const QString& name) { return copyOne(m_outbox, folder, name); });
}

QString WorkArchive::addAnswers(const QString& folder, const TurnAnswers& answers) const
{
    return answers.write(locate(folder, answers.turnId));
}

QStringList WorkArchive::worksIn(const QString& classFolder)
{
    QStringList names = QDir(classFolder).entryList(QDir::Dirs | QDir::NoDotAndDotDot), works;
    std::sort(names.begin(), names.end(), ui::nameCollator());
    for (const QString& name : names) {
        const QString folder = classFolder + u'/' + name;
        if (isWork(folder))
            works << folder;
    }
    return works;
}

bool WorkArchive::isWork(const QString& folder)
{
    return QFileInfo(folder + u'/' + turnFile).isFile() && QFileInfo(modelOf(folder)).isFile();
}

TurnFacts WorkArchive::turnOf(const QString& work)
{
    QFile file(work + u'/' + turnFile);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    const QJsonObject turn = QJsonDocument::fromJson(file.read(maxTurnBytes)).object();
    const auto time = [&turn](const QString& key) {
        return QDateTime::fromString(turn.value(key).toString(), Qt::ISODate);
    };
    const double used = turn.value(turnUsedKey).toDouble(-1); // works of older versions have no used time
    return {turn.value(turnIdKey).toString(),
            turn.value(turnNameKey).toString(),
            time(turnBegunKey),
            time(turnEndedKey),
            LessonResult::from(turn.value(turnLessonKey).toObject()),
            used < 0 ? std::nullopt : std::optional(used)};
}

QString WorkArchive::modelOf(const QString& work)
{
    return work + u'/' + modelFile;
}

QString WorkArchive::locate(const QString& folder, const QString& id) const
{
    if (QFileInfo::exists(folder))
        return folder;
    const auto isTurn = [&id](const QByteArray& turn) { return idIn(turn) == id; };
    const QString delivered = findWork(m_classFolder, QFileInfo(folder).fileName(), isTurn);
    return delivered.isEmpty() ? folder : delivered;
}

QStringList WorkArchive::pupilsOf(const QDate& day) const
{
    QStringList pupils;
    for (const QString& root : {m_classFolder, m_outbox})
        for (const QString& work : worksIn(root))
            if (const TurnFacts turn = turnOf(work); turn.begun.date() == day)
                pupils << turn.pupil;
    return pupils;
}

void WorkArchive::removeUnfinished() const
{
    const QDateTime stale = QDateTime::currentDateTime().addSecs(-3600 * staleHours);
    for (const QString& root : {m_outbox, m_classFolder})
        for (const QFileInfo& part :
             QDir(root).entryInfoList({unfinished + u'*'}, QDir::Dirs | QDir::Hidden | QDir::NoDotAndDotDot))
            if (root == m_outbox || part.lastModified() < stale)
                QDir(part.filePath()).removeRecursively();
}
} // namespace app
