#include "app/classroom/class_paths.h"
#include "app/classroom/work_archive.h"
#include "app/model/model_loader.h"
#include "tests/support/test_main.h"

#include "core/io/mesh_io.h"
#include "core/primitives/starter_models.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>

using namespace app;

namespace
{
/// A simulated computer with its own data folders and a class folder.
struct Computer
{
    Computer()
    {
        qputenv("XDG_DATA_HOME", QFile::encodeName(root.filePath(QStringLiteral("data"))));
        qputenv("XDG_STATE_HOME", QFile::encodeName(root.filePath(QStringLiteral("state"))));
        QDir().mkpath(works);
        for (const char* name : {"5b.ini", "5b.fettleclass"})
            QFile(file(name)).open(QIODevice::WriteOnly);
    }

    QString file(const char* name) const { return root.filePath(QLatin1StringView(name)); }
    QString classes() const { return root.filePath(QStringLiteral("data/fettle/classes")); }
    ClassPaths prepared(const QString& folder) const { return ClassPaths::prepare(file("5b.ini"), folder); }
    /// Returns the folder in which older versions kept the undelivered works of a class file.
    QString outboxBefore(const char* classFile) const
    {
        const QByteArray path = QFileInfo(file(classFile)).canonicalFilePath().toUtf8();
        const QByteArray key = QCryptographicHash::hash(path, QCryptographicHash::Sha256).toHex().left(16);
        return classes() + u'/' + QString::fromLatin1(key) + QStringLiteral("/waiting");
    }
    /// Adds an undelivered work to the outbox.
    static void add(const QString& outbox, const QString& pupil)
    {
        static int count = 0;
        TurnWork work;
        work.id = QString::number(++count);
        work.pupil = pupil;
        work.begun = work.ended = QDateTime({2026, 11, 24}, {10, 15});
        work.mesh = std::make_shared<const core::TriangleMesh>(core::starterModel(core::Starter::Cube));
        QCOMPARE(WorkArchive(QString(), outbox).add(work).problem, QString());
    }
    static QStringList pupilsIn(const QString& outbox)
    {
        QStringList pupils;
        for (const QString& work : WorkArchive::worksIn(outbox))
            pupils << WorkArchive::turnOf(work).pupil;
        return pupils;
    }

    QTemporaryDir root;
    QString works = root.filePath(QStringLiteral("works")), link = root.filePath(QStringLiteral("link"));
};
} // namespace

/// Tests that each class folder has one outbox for undelivered works, whatever names the folder and the class file
/// have.
class TestClassPaths : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aFolder_hasOnePlace()
    {
        const Computer computer;
        QVERIFY(QFile::link(computer.works, computer.link));
        const ClassPaths paths = computer.prepared(computer.works);
        for (const QString& spelling :
             {computer.works + u'/', computer.works + QStringLiteral("/../works"), computer.link}) {
            const ClassPaths same = ClassPaths::prepare(computer.file("5b.fettleclass"), spelling);
            QCOMPARE(same.outbox, paths.outbox);
            QCOMPARE(same.turnNote, paths.turnNote);
            QVERIFY(same.journals == paths.journals);
        }
        const ClassPaths other = computer.prepared(computer.root.filePath(QStringLiteral("others")));
        QVERIFY(other.outbox != paths.outbox && other.journals != paths.journals);
    }

    void aFolderThatIsGone_isKnownByItsNames()
    {
        const Computer computer;
        QVERIFY(QFile::link(computer.works, computer.link));
        const QString outbox = computer.prepared(computer.link).outbox;
        QVERIFY(QDir().rmdir(computer.works));
        QCOMPARE(computer.prepared(computer.link).outbox, outbox);
        QCOMPARE(computer.prepared(computer.works).outbox, outbox);
    }

    void twoNames_areFoundToBeOneFolder()
    {
        const Computer computer;
        const QString byLink = computer.prepared(computer.link).outbox,
                      byName = computer.prepared(computer.works).outbox;
        QVERIFY(byLink != byName); // the link's target does not exist yet
        Computer::add(byLink, QStringLiteral("Anna"));
        Computer::add(byName, QStringLiteral("Ben"));
        Computer::add(byName, QStringLiteral("Anna")); // a second work of Anna in the same minute
        QVERIFY(QFile::link(computer.works, computer.link));
        const QString both = computer.prepared(computer.link).outbox;
        QCOMPARE(Computer::pupilsIn(both), QStringList({"Anna", "Anna", "Ben"}));
        QCOMPARE(Computer::pupilsIn(both == byLink ? byName : byLink), QStringList());
        QCOMPARE(computer.prepared(computer.works).outbox, both);
    }

    void worksOfOlderVersions_areFound()
    {
        const Computer computer;
        Computer::add(computer.outboxBefore("5b.ini"), QStringLiteral("Anna"));
        Computer::add(computer.outboxBefore("5b.fettleclass"), QStringLiteral("Ben"));
        QCOMPARE(Computer::pupilsIn(computer.prepared(computer.works).outbox), QStringList({"Anna"}));
        const QString outbox = ClassPaths::prepare(computer.file("5b.fettleclass"), computer.works).outbox;
        QCOMPARE(Computer::pupilsIn(outbox), QStringList({"Anna", "Ben"}));
        QVERIFY(computer.prepared(computer.root.filePath(QStringLiteral("others"))).outbox !=
                outbox); // the class file now names a different folder
    }

    void journals_areNotLeftBehind()
    {
        const Computer computer;
        const ClassPaths byLink = computer.prepared(computer.link), byName = computer.prepared(computer.works);
        QVERIFY(QFile::link(computer.works, computer.link));
        for (const ClassPaths& one : {byLink, byName}) {
            const std::filesystem::path journal = one.journals / "1";
            std::filesystem::create_directories(journal);
            QVERIFY(computer.prepared(computer.link).journals == one.journals);
            std::filesystem::remove(journal);
        }
    }

    void whatWaits_isListed()
    {
        const Computer computer;
        QVERIFY(ClassPaths::waiting().isEmpty());
        const QString gone = computer.root.filePath(QStringLiteral("gone"));
        const QString outbox = computer.prepared(gone).outbox;
        QVERIFY(ClassPaths::waiting().isEmpty());
        Computer::add(outbox, QStringLiteral("Anna"));
        Computer::add(outbox, QStringLiteral("Ben"));
        Computer::add(computer.outboxBefore("5b.fettleclass"), QStringLiteral("Cem"));
        QHash<QString, int> counts;
        for (const WaitingWorks& works : ClassPaths::waiting())
            counts.insert(works.folder, works.count);
        QCOMPARE(counts, (QHash<QString, int>{{gone, 2}, {QString(), 1}}));
    }
};

FETTLE_TEST(TestClassPaths)
#include "tst_class_paths.moc"
