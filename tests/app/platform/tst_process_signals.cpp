// Tests signals that the window must survive and that its child processes must not inherit as ignored.
#include "app/platform/child_process.h"
#include "app/platform/process_signals.h"
#include "tests/support/effort.h"
#include "tests/support/test_main.h"

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <cerrno>
#include <csignal>
#include <unistd.h>

namespace
{
/// Returns whether a process ignores SIGPIPE, given the text of its /proc/PID/status.
bool ignoresBrokenPipes(const QByteArray& status)
{
    const qsizetype at = status.indexOf("SigIgn:");
    const quint64 mask = at < 0 ? 0 : status.mid(at + 7, 17).trimmed().toULongLong(nullptr, 16);
    return (mask & (quint64(1) << (SIGPIPE - 1))) != 0;
}

QByteArray contents(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QByteArray byProcess()
{
    QProcess cat;
    cat.start(QStringLiteral("cat"), {QStringLiteral("/proc/self/status")});
    cat.waitForFinished(longestWait);
    return cat.readAllStandardOutput();
}

QByteArray byDetachedProcess()
{
    const QTemporaryDir folder;
    const QString answer = folder.filePath(QStringLiteral("answer"));
    QProcess::startDetached(QStringLiteral("sh"),
                            {QStringLiteral("-c"), QStringLiteral("cat /proc/self/status >part; mv part answer")},
                            folder.path());
    [&] { QTRY_VERIFY(QFile::exists(answer)); }();
    return contents(answer);
}

QByteArray byOwnChild()
{
    return QByteArray::fromStdString(
        app::runChild({{"/bin/cat", "/proc/self/status"}, std::chrono::seconds(60), 1 << 20}).bytes);
}
} // namespace

class TestProcessSignals : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { app::surviveBrokenPipes(); }
    void brokenPipe_isAnError();
    void children_doNotIgnoreBrokenPipes_data();
    void children_doNotIgnoreBrokenPipes();
    void window_survivesABrokenPipe();
};

void TestProcessSignals::brokenPipe_isAnError()
{
    int ends[2] = {};
    QCOMPARE(pipe(ends), 0);
    close(ends[0]);
    QCOMPARE(write(ends[1], "x", 1), ssize_t(-1));
    QCOMPARE(errno, EPIPE);
    close(ends[1]);
}

void TestProcessSignals::children_doNotIgnoreBrokenPipes_data()
{
    QTest::addColumn<QByteArray>("status");
    QTest::newRow("QProcess") << byProcess();
    QTest::newRow("QProcess, detached") << byDetachedProcess();
    QTest::newRow("runChild") << byOwnChild();
}

void TestProcessSignals::children_doNotIgnoreBrokenPipes()
{
    QFETCH(QByteArray, status);
    QVERIFY(ignoresBrokenPipes(contents(QStringLiteral("/proc/self/status"))));
    QVERIFY(status.contains("SigIgn:"));
    QVERIFY(!ignoresBrokenPipes(status));
}

/// Simulates the client library of an OpenXR runtime that writes to a service that has just ended.
void TestProcessSignals::window_survivesABrokenPipe()
{
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("DBUS_SESSION_BUS_ADDRESS"),
                       QStringLiteral("disabled:")); // libdbus would ignore SIGPIPE itself
    QProcess fettle;
    fettle.setProcessEnvironment(environment);
    fettle.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    fettle.start(QStringLiteral(FETTLE_PROGRAM), QStringList());
    QVERIFY(fettle.waitForStarted(longestWait));
    QTRY_VERIFY(ignoresBrokenPipes(contents(QStringLiteral("/proc/%1/status").arg(fettle.processId()))));
    QCOMPARE(kill(static_cast<pid_t>(fettle.processId()), SIGPIPE), 0);
    QVERIFY(!fettle.waitForFinished(500));
    fettle.kill();
    QVERIFY(fettle.waitForFinished(longestWait));
}

FETTLE_TEST(TestProcessSignals, QCoreApplication)
#include "tst_process_signals.moc"
