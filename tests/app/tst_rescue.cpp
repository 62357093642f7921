#include "app/document.h"
#include "app/rescue.h"

#include "core/mesh_check.h"
#include "core/mesh_io.h"
#include "ui/settings.h"

#include <QApplication>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <QWidget>

using namespace app;

namespace
{
constexpr core::Rgb red{250, 10, 20};
constexpr int longestWait = 60'000;

/// What the test starts on a display of its own: a window, and a document with a change that no file holds, or with none.
int runVictim(bool changes)
{
    SculptWorker worker;
    Document document(&worker);
    QWidget window;
    window.show();
    const Rescue rescue(&document, &worker);
    QObject::connect(&document, &Document::opened, &document, [&] {
        if (changes)
            document.apply(core::Fill{red});
        else
            std::puts("ready");
        std::fflush(stdout);
    });
    QObject::connect(&document, &Document::modifiedChanged, &document, [] {
        std::puts("ready");
        std::fflush(stdout);
    });
    document.openStarter(core::Starter::Head);
    return QApplication::exec();
}

/// A display server of our own.
class XServer
{
public:
    XServer()
    {
        m_server.start(QStringLiteral("Xvfb"), {QStringLiteral("-displayfd"), QStringLiteral("1"), QStringLiteral("-screen"), QStringLiteral("0"),
                                                QStringLiteral("640x480x24")});
        m_server.waitForReadyRead(longestWait);
        m_name = ":" + m_server.readLine().trimmed();
    }
    ~XServer() { die(); }
    const QByteArray& name() const { return m_name; }
    void die()
    {
        m_server.kill();
        m_server.waitForFinished(longestWait);
    }

private:
    QProcess m_server;
    QByteArray m_name;
};
} // namespace

/// The display is taken away from a program that is at work.
class TestRescue : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theModelOutlivesTheDisplay();
    void withoutChanges_nothingIsKept();

private:
    /// What the victim says on stderr at its end.
    QByteArray killDisplayOf(const QStringList& arguments);

    QTemporaryDir m_home;
};

QByteArray TestRescue::killDisplayOf(const QStringList& arguments)
{
    XServer display;
    QProcess victim;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("DISPLAY"), QString::fromLatin1(display.name()));
    environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("xcb"));
    environment.insert(QStringLiteral("XDG_DATA_HOME"), m_home.path());
    victim.setProcessEnvironment(environment);
    victim.start(QCoreApplication::applicationFilePath(), arguments);
    if (!victim.waitForReadyRead(longestWait) || !victim.readAllStandardOutput().contains("ready"))
        return "not ready: " + victim.readAllStandardError();
    display.die();
    if (!victim.waitForFinished(longestWait) || victim.exitStatus() != QProcess::NormalExit)
        return "did not end in order";
    return victim.readAllStandardError();
}

void TestRescue::theModelOutlivesTheDisplay()
{
    const QByteArray word = killDisplayOf({QStringLiteral("--victim"), QStringLiteral("changed")});
    const QByteArray kept = "the model was kept in ";
    QVERIFY2(word.contains(kept), word.constData());
    const QString path = QString::fromLocal8Bit(word.mid(word.indexOf(kept) + kept.size()).split('\n').first().chopped(1));
    const core::TriangleMesh mesh = core::readMesh(path.toStdU16String());
    QVERIFY(core::checkMesh(mesh).printReady());
    QVERIFY(!mesh.colors.empty() && mesh.colors.front() == red);
    QCOMPARE(ui::Settings().recentFiles().value(0), path);
}

void TestRescue::withoutChanges_nothingIsKept()
{
    const QByteArray word = killDisplayOf({QStringLiteral("--victim"), QStringLiteral("unchanged")});
    QVERIFY2(!word.contains("kept") && !word.contains("not ready"), word.constData());
}

int main(int argc, char* argv[])
{
    QCoreApplication::setOrganizationName(QStringLiteral("FettleTest"));
    QCoreApplication::setApplicationName(QStringLiteral("tst_rescue"));
    if (argc == 3 && qstrcmp(argv[1], "--victim") == 0) {
        const QApplication application(argc, argv);
        return runVictim(qstrcmp(argv[2], "changed") == 0);
    }
    const QCoreApplication application(argc, argv);
    TestRescue test;
    return QTest::qExec(&test, argc, argv);
}
#include "tst_rescue.moc"
