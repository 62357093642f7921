#include "tests/support/test_main.h"
#include "tests/ui/files/write_model.h"
#include "ui/files/file_jobs.h"
#include "ui/files/thumbnail_maker.h"

#include "core/io/mesh_io.h"
#include "core/primitives/starter_models.h"

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using ui::FileEntry;
using ui::FileJobs;
using ui::Thumbnail;
using ui::ThumbnailCache;
using ui::ThumbnailMaker;

namespace
{
/// A maker with its own cache, and records of the pictures made.
struct Maker
{
    explicit Maker(const QString& cache) : maker(cache)
    {
        QObject::connect(&maker, &ThumbnailMaker::made, &here,
                         [this](const FileEntry& file, const Thumbnail& thumbnail) {
                             order << QFileInfo(file.path).fileName();
                             last = thumbnail;
                         });
    }
    Thumbnail one(const QString& path)
    {
        order.clear();
        maker.request({FileJobs::entryOf(path)});
        [this] { QTRY_COMPARE(order.size(), 1); }();
        return last;
    }

    QObject here;
    QStringList order;
    Thumbnail last;
    ThumbnailMaker maker; ///< destroyed first, because its signals use the others
};

Thumbnail plain(QRgb color)
{
    QImage picture(ui::thumbnailPixels, ui::thumbnailPixels, QImage::Format_ARGB32_Premultiplied);
    picture.fill(color);
    return {picture, 7, {}};
}
} // namespace

class TestThumbnailMaker : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theSameContentIsDrawnOnce()
    {
        const QTemporaryDir folder;
        const QString one = folder.filePath(QStringLiteral("one.obj")),
                      copy = folder.filePath(QStringLiteral("copy.obj"));
        const QString cache = folder.filePath(QStringLiteral("cache/deep"));
        writeModel(one, core::starterModel(core::Starter::Vase));
        QVERIFY(QFile::copy(one, copy));
        QImage first;
        {
            Maker m(cache);
            first = m.one(one).picture;
            QCOMPARE(m.maker.drawn(), 1);
            QCOMPARE(m.one(copy).picture, first);
            QCOMPARE(m.maker.drawn(), 1);
        }
        Maker later(cache);
        const Thumbnail again = later.one(copy);
        QCOMPARE(later.maker.drawn(), 0);
        QCOMPARE(again.picture, first);
        QCOMPARE(again.vertices, qint64(core::starterModel(core::Starter::Vase).points.size()));
        writeModel(copy, core::starterModel(core::Starter::Cube));
        QVERIFY(later.one(copy).picture != first);
        QCOMPARE(later.maker.drawn(), 1);
    }

    void aFileThatIsGoneOrBadComesWithTheReason()
    {
        const QTemporaryDir folder;
        Maker m(folder.filePath(QStringLiteral("cache")));
        const QString gone = folder.filePath(QStringLiteral("gone.stl"));
        writeModel(gone, core::icosphere(2, 1));
        const FileEntry entry = FileJobs::entryOf(gone);
        QVERIFY(QFile::remove(gone));
        m.maker.request({entry});
        QTRY_COMPARE(m.order.size(), 1);
        QVERIFY(m.last.picture.isNull() && m.last.problem.contains(QStringLiteral("gone.stl")) &&
                m.last.problem.endsWith(QLatin1Char('.')));
        QFile empty(folder.filePath(QStringLiteral("empty.ply")));
        QVERIFY(empty.open(QIODevice::WriteOnly));
        QVERIFY(m.one(empty.fileName()).problem.contains(QStringLiteral("empty.ply")));
        QVERIFY(m.one(folder.path()).picture.isNull());
    }

    void theyComeInTheOrderOfTheLastRequest()
    {
        const QTemporaryDir folder;
        Maker m(folder.filePath(QStringLiteral("cache")));
        QList<FileEntry> files;
        for (int i = 0; i < 8; ++i) {
            const QString path = folder.filePath(QStringLiteral("%1.stl").arg(i));
            writeModel(path, core::icosphere(2, 1 + i));
            files << FileJobs::entryOf(path);
        }
        m.maker.request(files);
        m.maker.request({files[5], files[2]});
        QTRY_VERIFY(m.order.contains(QStringLiteral("2.stl")));
        m.order.removeAll(QStringLiteral("0.stl")); // may have been finished before the second request
        QCOMPARE(m.order, QStringList({QStringLiteral("5.stl"), QStringLiteral("2.stl")}));
    }

    void whatIsNotWantedIsGivenUp_data()
    {
        QTest::addColumn<QString>("name");
        QTest::newRow("bytes") << QStringLiteral("large.stl");
        QTest::newRow("text") << QStringLiteral("large.obj");
    }

    /// The drawing of a large file is cancelled at any stage when it is no longer requested.
    void whatIsNotWantedIsGivenUp()
    {
        QFETCH(QString, name);
        const QTemporaryDir folder;
        const QString large = folder.filePath(name), small = folder.filePath(QStringLiteral("small.stl"));
        writeModel(large, core::icosphere(8, 10)); // 655,362 vertices
        writeModel(small, core::icosphere(2, 10));
        for (const int delayMs : {1, 40, 150}) {
            Maker m(folder.filePath(QStringLiteral("cache%1").arg(delayMs)));
            m.maker.request({FileJobs::entryOf(large)});
            QTest::qWait(delayMs);
            m.maker.request({FileJobs::entryOf(small)});
            QTRY_VERIFY(!m.order.isEmpty() && m.order.constLast() == QStringLiteral("small.stl"));
            QCOMPARE(m.maker.drawn(), m.order.size());
            QVERIFY(m.order.size() == 1 || delayMs > 1); // after a longer delay, the large file may be finished
        }
    }

    void theCacheIsBounded()
    {
        const QTemporaryDir folder;
        ThumbnailCache cache(folder.path(), 20);
        for (int i = 0; i < 50; ++i)
            cache.store(QByteArray::number(i), plain(qRgb(i, 0, 0)));
        const auto count = QDir(folder.path()).entryList({QStringLiteral("*.png")}).size();
        QVERIFY(count > 10 && count <= 20);
        QCOMPARE(cache.find("49")->picture, plain(qRgb(49, 0, 0)).picture);
        QCOMPARE(cache.find("49")->vertices, 7);
        QVERIFY(!cache.find("0"));
    }

    void aBrokenCacheIsNoPicture()
    {
        const QTemporaryDir folder;
        ThumbnailCache cache(folder.path());
        cache.store("a", plain(Qt::red));
        QVERIFY(cache.find("a"));
        QVERIFY(QFile::resize(folder.filePath(QStringLiteral("a.png")), 60));
        QVERIFY(!cache.find("a"));
        QVERIFY(QImage(16, 16, QImage::Format_ARGB32).save(folder.filePath(QStringLiteral("b.png"))));
        QVERIFY(!cache.find("b"));
        ThumbnailCache nowhere(QStringLiteral("/dev/null/cache"));
        nowhere.store("c", plain(Qt::red));
        QVERIFY(!nowhere.find("c"));
        const QTemporaryDir models;
        writeModel(models.filePath(QStringLiteral("m.stl")), core::icosphere(2, 1));
        Maker m(QStringLiteral("/dev/null/cache"));
        QVERIFY(!m.one(models.filePath(QStringLiteral("m.stl"))).picture.isNull());
    }
};

FETTLE_TEST(TestThumbnailMaker, QCoreApplication)
#include "tst_thumbnail_maker.moc"
