#include "app/classroom/work_archive.h"
#include "app/model/model_loader.h"

#include "tests/support/test_main.h"
#include "tests/support/unwritable_places.h"

#include "core/mesh/mesh_builder.h"
#include "core/primitives/starter_models.h"
#include "core/sculpt/sculptor.h"

#include <QDir>
#include <QImage>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

using namespace app;

namespace
{
const QDateTime morning(QDate(2026, 11, 24), QTime(10, 15, 2));

TurnWork workOf(const QString& pupil, core::Starter starter = core::Starter::Torus)
{
    static int count = 0;
    const LoadedModel model = ModelLoader::starter(starter);
    TurnWork work{QString::number(++count),          pupil, morning, morning.addSecs(600), 1, nullptr,
                  model.sculptor->mesh().meshHash(), {},    {}};
    work.mesh = std::make_shared<core::TriangleMesh>(core::extractMesh(model.sculptor->mesh()));
    work.metadata.frame = model.sculptor->mesh().frame();
    core::Stroke stroke;
    stroke.settings.radius = 12;
    stroke.samples.emplace_back().position = {0, 50, 0};
    work.record = std::vector<core::FileEntry>{stroke};
    return work;
}

QByteArray contentsOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// A class folder and an outbox for undelivered works.
struct Places
{
    explicit Places(const QString& classFolder = {})
        : works(classFolder.isEmpty() ? root.filePath(QStringLiteral("class")) : classFolder)
    {
        QDir().mkpath(works);
    }
    WorkArchive archive() const { return {works, outbox}; }
    static QStringList all(const QString& folder)
    {
        return QDir(folder).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot, QDir::Name);
    }

    QTemporaryDir root;
    QString works, outbox = root.filePath(QStringLiteral("own/waiting"));
};

void verifyWork(const QString& folder, const TurnWork& work)
{
    QCOMPARE(Places::all(folder), QStringList({"model.glb", "picture.png", "record.json", "turn.json"}));
    const LoadedModel model = ModelLoader::loadInPlace(folder + QStringLiteral("/model.glb"));
    QVERIFY2(model.sculptor, qPrintable(model.problem));
    QCOMPARE(model.sculptor->mesh().meshHash(), work.meshHash);
    const QImage picture(folder + QStringLiteral("/picture.png"));
    QVERIFY(!picture.isNull() && picture.hasAlphaChannel());
    const auto entries = core::readStrokes((folder + QStringLiteral("/record.json")).toStdString());
    QCOMPARE(entries.size(), work.record->size());
    const QJsonObject turn = QJsonDocument::fromJson(contentsOf(folder + QStringLiteral("/turn.json"))).object();
    QCOMPARE(turn.value(QStringLiteral("name")).toString(), work.pupil);
    QCOMPARE(turn.value(QStringLiteral("begun")).toString(), QStringLiteral("2026-11-24T10:15:02"));
    QCOMPARE(turn.value(QStringLiteral("mesh_hash")).toString().toULongLong(nullptr, 16), work.meshHash);
}
} // namespace

/// Tests that works are complete where they are visible, and never lost.
class TestWorkArchive : public QObject
{
    Q_OBJECT

public:
    static inline const places::SmallDisk* disk = nullptr; ///< small disk, mounted by main()

private Q_SLOTS:
    void aWorkIsWholeAndGoesToItsFolder();
    void names_areFolders_data();
    void names_areFolders();
    void sameNamesInAMinute_areNumbered();
    void aPause_comesBetweenWorks();
    void copies_leaveWhatWaits();
    void aMissingFolder_isSaidAndWaitedFor();
    void aClosedFolder_isSaidAndWaitedFor();
    void aFullDisk_isSaidAndWaitedFor();
    void aFullDiskHere_goesToTheClassAtOnce();
    void noRoomAnywhere_isSaid();
    void aCutDelivery_isNotDoubled();
    void leftovers_areSwept();
};

void TestWorkArchive::aWorkIsWholeAndGoesToItsFolder()
{
    const Places places;
    const TurnWork work = workOf(QStringLiteral("Anna"));
    const ArchivedWork kept = places.archive().add(work);
    QCOMPARE(kept.problem, QString());
    QCOMPARE(kept.folder, places.outbox + QStringLiteral("/2026-11-24-1015-Anna"));
    verifyWork(kept.folder, work);
    const Delivery delivery = places.archive().deliver();
    QVERIFY(delivery.undelivered == 0 && delivery.problem.isEmpty());
    const QString there = places.works + QStringLiteral("/2026-11-24-1015-Anna");
    QCOMPARE(delivery.moved.value(kept.folder), there);
    QCOMPARE(places.archive().locate(kept.folder, work.id), there);
    QCOMPARE(places.archive().locate(there, work.id), there);
    // an unknown work is not located elsewhere
    QCOMPARE(places.archive().locate(kept.folder, QStringLiteral("another")), kept.folder);
    verifyWork(there, work);
    QCOMPARE(Places::all(places.outbox), QStringList());
    QCOMPARE(Places::all(places.works).size(), 1);
}

void TestWorkArchive::names_areFolders_data()
{
    QTest::addColumn<QString>("pupil");
    QTest::addColumn<QString>("end");
    const auto row = [](const char* name, const char* pupil, const char* end) {
        QTest::newRow(name) << QString::fromUtf8(pupil) << QString::fromUtf8(end);
    };
    row("plain", "Anna", "Anna");
    row("two words", "  Anna   Lena ", "Anna-Lena");
    row("up", "../x", "x");
    row("root", "/", "unnamed");
    row("dots", "..", "unnamed");
    row("a device", "CON", "CON");
    row("nothing", "", "unnamed");
    row("forbidden", "a\\b:c*d?e\"f<g>h|i\n", "abcdefghi");
    row("not Latin", "小明 Ögür", "小明-Ögür");
    row("emoji", "🦊", "🦊");
    row("hidden", ".unfinished-x", "unfinished-x");
    row("long", "abcdefghijabcdefghijabcdefghijabcdefghijabcdefghij", "abcdefghijabcdefghijabcdefghijabcdefghij");
}

void TestWorkArchive::names_areFolders()
{
    QFETCH(QString, pupil);
    QFETCH(QString, end);
    const QString name = WorkArchive::folderName(morning, pupil);
    QCOMPARE(name, QStringLiteral("2026-11-24-1015-") + end);
    const Places places;
    const TurnWork work = workOf(pupil);
    places.archive().add(work);
    QCOMPARE(places.archive().deliver().moved.size(), 1);
    QCOMPARE(Places::all(places.works), QStringList(name));
    verifyWork(places.works + u'/' + name, work);
    QCOMPARE(Places::all(places.root.path()), QStringList({"class", "own"}));
}

void TestWorkArchive::sameNamesInAMinute_areNumbered()
{
    const Places places;
    const TurnWork first = workOf(QStringLiteral("Anna")), second = workOf(QStringLiteral("Anna"), core::Starter::Cube);
    places.archive().add(first);
    places.archive().deliver();
    places.archive().add(second); // the first work has been delivered meanwhile
    places.archive().add(workOf(QStringLiteral("Anna"), core::Starter::Slab));
    QCOMPARE(places.archive().deliver().moved.size(), 2);
    QCOMPARE(Places::all(places.works),
             QStringList({"2026-11-24-1015-Anna", "2026-11-24-1015-Anna-2", "2026-11-24-1015-Anna-2-2"}));
    verifyWork(places.works + QStringLiteral("/2026-11-24-1015-Anna"), first);
    verifyWork(places.works + QStringLiteral("/2026-11-24-1015-Anna-2"), second);
}

void TestWorkArchive::aPause_comesBetweenWorks()
{
    const Places places;
    for (const char* pupil : {"Anna", "Ben", "Cem"})
        QCOMPARE(places.archive().add(workOf(QLatin1StringView(pupil))).problem, QString());
    int asked = 0;
    const Delivery part = places.archive().deliver([&asked] { return ++asked > 2; });
    QVERIFY(part.isPaused && part.moved.size() == 2 && part.undelivered == 0);
    QCOMPARE(Places::all(places.works).size(), 2);
    QCOMPARE(Places::all(places.outbox).size(), 1);
    const Delivery rest = places.archive().deliver([] { return false; });
    QVERIFY(!rest.isPaused && rest.moved.size() == 1);
    QCOMPARE(Places::all(places.works).size(), 3);
}

/// Copies are complete and not duplicated, and the works remain in the outbox.
void TestWorkArchive::copies_leaveWhatWaits()
{
    const Places places;
    const TurnWork work = workOf(QStringLiteral("Anna"));
    const ArchivedWork kept = places.archive().add(work);
    const QString stick = places.root.filePath(QStringLiteral("stick"));
    QVERIFY(!places.archive().copy(stick).problem.isEmpty());
    QDir().mkpath(stick);
    for (int i = 0; i < 2; ++i) {
        const Delivery copied = places.archive().copy(stick);
        QVERIFY2(copied.problem.isEmpty() && copied.moved.size() == 1, qPrintable(copied.problem));
        QCOMPARE(Places::all(stick).size(), 1);
    }
    verifyWork(stick + QStringLiteral("/2026-11-24-1015-Anna"), work);
    verifyWork(kept.folder, work);
    QCOMPARE(places.archive().deliver().moved.size(), 1);
}

void TestWorkArchive::aMissingFolder_isSaidAndWaitedFor()
{
    const Places places;
    QDir().rmdir(places.works);
    const TurnWork work = workOf(QStringLiteral("Ben"));
    const ArchivedWork kept = places.archive().add(work);
    const Delivery delivery = places.archive().deliver();
    QCOMPARE(delivery.undelivered, 1);
    QVERIFY2(delivery.problem.contains(QStringLiteral("the folder %1 does not exist").arg(places.works)),
             qPrintable(delivery.problem));
    QVERIFY(!QDir(places.works).exists());
    verifyWork(kept.folder, work);
    QDir().mkpath(places.works); // as when the folder is mounted again
    QCOMPARE(places.archive().deliver().moved.size(), 1);
    verifyWork(places.works + QStringLiteral("/2026-11-24-1015-Ben"), work);
}

void TestWorkArchive::aClosedFolder_isSaidAndWaitedFor()
{
    const Places places;
    QFile::setPermissions(places.works, QFile::ReadOwner | QFile::ExeOwner);
    const TurnWork work = workOf(QStringLiteral("Ben"));
    places.archive().add(work);
    const Delivery delivery = places.archive().deliver();
    QFile::setPermissions(places.works, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    QVERIFY2(delivery.undelivered == 1 && delivery.problem.contains(QStringLiteral("not allowed")),
             qPrintable(delivery.problem));
    QCOMPARE(places.archive().deliver().moved.size(), 1);
    verifyWork(places.works + QStringLiteral("/2026-11-24-1015-Ben"), work);
}

void TestWorkArchive::aFullDisk_isSaidAndWaitedFor()
{
    if (!disk->isThere())
        QSKIP("A small disk cannot be mounted here.");
    const Places places(QString::fromStdString(disk->folder().string()));
    disk->fill();
    const TurnWork work = workOf(QStringLiteral("Ben"));
    const ArchivedWork kept = places.archive().add(work);
    const Delivery delivery = places.archive().deliver();
    QVERIFY2(delivery.undelivered == 1 && delivery.problem.endsWith(QStringLiteral("the disk is full.")),
             qPrintable(delivery.problem));
    QCOMPARE(Places::all(places.works), QStringList(QStringLiteral("filler")));
    verifyWork(kept.folder, work);
    QFile::remove(places.works + QStringLiteral("/filler"));
    QCOMPARE(places.archive().deliver().moved.size(), 1);
    verifyWork(places.works + QStringLiteral("/2026-11-24-1015-Ben"), work);
    QDir(places.works + QStringLiteral("/2026-11-24-1015-Ben")).removeRecursively();
}

void TestWorkArchive::aFullDiskHere_goesToTheClassAtOnce()
{
    if (!disk->isThere())
        QSKIP("A small disk cannot be mounted here.");
    Places places;
    places.outbox = QString::fromStdString(disk->folder().string());
    disk->fill();
    const TurnWork work = workOf(QStringLiteral("Ben"));
    const ArchivedWork kept = places.archive().add(work);
    QFile::remove(places.outbox + QStringLiteral("/filler"));
    QCOMPARE(kept.folder, places.works + QStringLiteral("/2026-11-24-1015-Ben"));
    verifyWork(kept.folder, work);
    QCOMPARE(Places::all(places.outbox), QStringList());
}

void TestWorkArchive::noRoomAnywhere_isSaid()
{
    if (!disk->isThere())
        QSKIP("A small disk cannot be mounted here.");
    Places places;
    places.outbox = QString::fromStdString(disk->folder().string());
    QDir().rmdir(places.works);
    disk->fill();
    const ArchivedWork kept = places.archive().add(workOf(QStringLiteral("Ben")));
    QFile::remove(places.outbox + QStringLiteral("/filler"));
    QVERIFY(kept.folder.isEmpty());
    QVERIFY2(kept.problem.endsWith(QStringLiteral("the disk is full.")), qPrintable(kept.problem));
    QCOMPARE(Places::all(places.outbox), QStringList());
}

/// Simulates a power cut after the work got its name in the class folder and before it was removed from the outbox.
void TestWorkArchive::aCutDelivery_isNotDoubled()
{
    const Places places;
    const TurnWork work = workOf(QStringLiteral("Cem"));
    places.archive().add(work);
    places.archive().deliver();
    const QStringList before = Places::all(places.works);
    const QString kept = places.archive().add(work).folder; // the work is still in the outbox
    QCOMPARE(places.archive().deliver().moved.value(kept), places.works + QStringLiteral("/2026-11-24-1015-Cem"));
    QCOMPARE(Places::all(places.works), before);
    QCOMPARE(Places::all(places.outbox), QStringList());
}

void TestWorkArchive::leftovers_areSwept()
{
    const Places places;
    places.archive().add(workOf(QStringLiteral("Dana")));
    const QString here = places.outbox + QStringLiteral("/.unfinished-1"),
                  there = places.works + QStringLiteral("/.unfinished-2");
    QVERIFY(QDir().mkpath(here) && QDir().mkpath(there));
    QVERIFY(places.archive().deliver().undelivered == 0); // neither unfinished folder is mistaken for a work
    places.archive().removeUnfinished();
    QVERIFY(!QDir(here).exists());
    QVERIFY(QDir(there).exists()); // another computer may still be writing it
    QCOMPARE(Places::all(places.works).size(), 2);
}

static int workArchiveMain(int argc, char* argv[])
{
    const QTemporaryDir folder;
    const places::SmallDisk disk(folder.filePath(QStringLiteral("small")).toStdString(), 2048);
    places::obeyPermissions();
    TestWorkArchive::disk = &disk;
    const QCoreApplication application(argc, argv);
    TestWorkArchive test;
    return QTest::qExec(&test, argc, argv);
}

FETTLE_TEST_MAIN(TestWorkArchive, workArchiveMain)
#include "tst_work_archive.moc"
