// Tests `fettle brush` as a script calls it.
#include "tests/support/test_main.h"

#include <QFile>
#include <QImage>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

namespace
{
struct BrushAnswer
{
    int status = -1;
    QString out, err;
};

BrushAnswer brush(const QStringList& arguments)
{
    QProcess program;
    program.start(QStringLiteral(FETTLE_PROGRAM), QStringList(QStringLiteral("brush")) + arguments);
    if (!program.waitForFinished(-1) || program.exitStatus() != QProcess::NormalExit)
        return {};
    return {program.exitCode(), QString::fromUtf8(program.readAllStandardOutput()),
            QString::fromUtf8(program.readAllStandardError())};
}
} // namespace

class TestBrushCommand : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void ours_areListed()
    {
        const BrushAnswer answer = brush({});
        QCOMPARE(answer.status, 0);
        QCOMPARE(answer.out.count(u'\n'), 16);
        QVERIFY(answer.err.isEmpty());
    }

    void aPreset_isToldAndDrawn()
    {
        const QTemporaryDir folder;
        const QString picture = folder.filePath(QStringLiteral("pores.png"));
        const BrushAnswer answer = brush({QStringLiteral("pores"), QStringLiteral("--picture"), picture});
        QCOMPARE(answer.status, 0);
        QVERIFY2(answer.out.contains(QStringLiteral("tool inflate")) && answer.out.contains(QStringLiteral("pores")),
                 qPrintable(answer.out));
        QVERIFY(!QImage(picture).isNull());
        const BrushAnswer noFolder =
            brush({QStringLiteral("pores"), QStringLiteral("--picture"), QStringLiteral("/nowhere/x.png")});
        QCOMPARE(noFolder.status, 2);
        QCOMPARE(noFolder.err.count(u'\n'), 1);
    }

    void bad_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("words");
        const QByteArray begin = R"({"format":"fettle-brush","version":1,"name":"A","stroke":{"tool":"clay",)";
        QTest::newRow("newer") << QByteArray(R"({"format":"fettle-brush","version":2})") << "newer version";
        QTest::newRow("no JSON") << QByteArray("{\n\"format\": x") << "line 2";
        QTest::newRow("strokes") << QByteArray(R"({"format":"fettle-strokes","version":1,"strokes":[]})")
                                 << "not a brush preset";
        QTest::newRow("range") << begin + R"("airbrush":100}})"
                               << "\"airbrush\" is out of range, 0 or 0.1 to 60";
        QTest::newRow("key") << begin + R"("glow":1}})"
                             << "glow";
        QTest::newRow("word") << begin + R"("topology":"finest"}})"
                              << "\"finest\"";
    }

    void bad()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, words);
        const QTemporaryDir folder;
        QFile file(folder.filePath(QStringLiteral("bad.json")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(text);
        file.close();
        const BrushAnswer answer = brush({file.fileName()});
        QCOMPARE(answer.status, 2);
        QVERIFY(answer.out.isEmpty());
        QCOMPARE(answer.err.count(u'\n'), 1);
        QVERIFY2(answer.err.contains(file.fileName()) && answer.err.contains(words), qPrintable(answer.err));
    }

    void usage()
    {
        for (const QStringList& arguments : {QStringList{QStringLiteral("/nowhere.json")},
                                             QStringList{QStringLiteral("pores"), QStringLiteral("carve")},
                                             QStringList{QStringLiteral("--picture"), QStringLiteral("x.png")}}) {
            const BrushAnswer answer = brush(arguments);
            QCOMPARE(answer.status, 2);
            QCOMPARE(answer.err.count(u'\n'), 1);
        }
        QCOMPARE(brush({QStringLiteral("--help")}).status, 0);
    }

    /// A preset whose alpha file is missing cannot be drawn.
    void anAlphaThatIsGone()
    {
        const QTemporaryDir folder;
        QFile file(folder.filePath(QStringLiteral("skin.json")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(R"({"format":"fettle-brush","version":1,"name":"A","stroke":{"tool":"clay","alpha":"skin.png"}})");
        file.close();
        const BrushAnswer answer =
            brush({file.fileName(), QStringLiteral("--picture"), folder.filePath(QStringLiteral("a.png"))});
        QCOMPARE(answer.status, 2);
        QVERIFY(answer.err.contains(QStringLiteral("skin.png")));
        QVERIFY(!QFile::exists(folder.filePath(QStringLiteral("a.png"))));
    }
};

FETTLE_TEST(TestBrushCommand, QCoreApplication)
#include "tst_brush_command.moc"
