#include "vr/openxr/active_runtime.h"
#include "vr/openxr/openxr_runtime.h"

#include "tests/support/test_main.h"

#include <QDir>
#include <QFile>
#include <QSysInfo>
#include <QTemporaryDir>
#include <QTest>

#include <map>
#include <memory>

using vr::ActiveRuntime;

class TestActiveRuntime : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup();

    void aMissingManifest_isSaid();
    void aBrokenManifest_isSaid_data();
    void aBrokenManifest_isSaid();
    void aMissingLibrary_isSaid();
    void aWholeManifest_hasNoFault();
    void theManifest_isTheSystems();
    void theStatus_saysWhatIsWrong();

private:
    QString path(const QString& name) const { return m_folder->filePath(name); }
    void write(const QString& name, const QByteArray& text) const;

    std::unique_ptr<QTemporaryDir> m_folder;
    std::map<QByteArray, QByteArray> m_before; ///< environment before the test
};

void TestActiveRuntime::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    for (const char* name : {"XR_RUNTIME_JSON", "XDG_CONFIG_HOME", "XDG_CONFIG_DIRS"}) {
        m_before[name] = qgetenv(name);
        qunsetenv(name);
    }
    qputenv("XDG_CONFIG_HOME", QFile::encodeName(path("home")));
    qputenv("XDG_CONFIG_DIRS", QFile::encodeName(path("system")));
}

void TestActiveRuntime::cleanup()
{
    for (const auto& [name, value] : m_before)
        value.isNull() ? qunsetenv(name.constData()) : qputenv(name.constData(), value);
}

void TestActiveRuntime::write(const QString& name, const QByteArray& text) const
{
    QDir().mkpath(QFileInfo(path(name)).path());
    QFile file(path(name));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(text);
}

void TestActiveRuntime::aMissingManifest_isSaid()
{
    QVERIFY(ActiveRuntime::faultOf({}, "XR_ERROR").contains("No OpenXR runtime is set up"));
    const QString fault = ActiveRuntime::faultOf(path("none.json"), "XR_ERROR");
    QVERIFY(fault.contains(path("none.json")) && fault.contains("missing") && fault.contains("XR_ERROR"));
}

void TestActiveRuntime::aBrokenManifest_isSaid_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("empty") << QByteArray();
    QTest::newRow("not JSON") << QByteArray("runtime");
    QTest::newRow("a list") << QByteArray("[1, 2]");
    QTest::newRow("no runtime") << QByteArray(R"({"file_format_version": "1.0.0"})");
    QTest::newRow("no library") << QByteArray(R"({"runtime": {"name": "X"}})");
    QTest::newRow("a number") << QByteArray(R"({"runtime": {"library_path": 7}})");
}

void TestActiveRuntime::aBrokenManifest_isSaid()
{
    QFETCH(QByteArray, text);
    write("broken.json", text);
    const QString fault = ActiveRuntime::faultOf(path("broken.json"), "XR_ERROR");
    QVERIFY2(fault.contains("names no runtime") && fault.contains(path("broken.json")), qPrintable(fault));
}

void TestActiveRuntime::aMissingLibrary_isSaid()
{
    write("sub/gone.json", R"({"runtime": {"library_path": "../lib/gone.so"}})");
    const QString fault = ActiveRuntime::faultOf(path("sub/gone.json"), "XR_ERROR");
    QVERIFY2(fault.contains(path("lib/gone.so")) || fault.contains("../lib/gone.so"), qPrintable(fault));
    QVERIFY(fault.contains(path("sub/gone.json")));
}

void TestActiveRuntime::aWholeManifest_hasNoFault()
{
    write("lib/there.so", "ELF");
    write("sub/whole.json", R"({"runtime": {"library_path": "../lib/there.so"}})");
    write("named.json",
          R"({"runtime": {"library_path": "libsomewhere.so"}})"); // the system looks for it in its folders
    QCOMPARE(ActiveRuntime::faultOf(path("sub/whole.json"), "XR_ERROR"), QString());
    QCOMPARE(ActiveRuntime::faultOf(path("named.json"), "XR_ERROR"), QString());
}

/// Checks the order of the places of a manifest on systems with XDG folders.
void TestActiveRuntime::theManifest_isTheSystems()
{
    if (QSysInfo::kernelType() == "linux") {
        write("system/openxr/1/active_runtime.json", "{}");
        QCOMPARE(ActiveRuntime::manifest(), path("system/openxr/1/active_runtime.json"));
        write("home/openxr/1/active_runtime.json", "{}");
        QCOMPARE(ActiveRuntime::manifest(), path("home/openxr/1/active_runtime.json"));
    }
    qputenv("XR_RUNTIME_JSON", QFile::encodeName(path("chosen.json")));
    QCOMPARE(ActiveRuntime::manifest(), path("chosen.json"));
}

void TestActiveRuntime::theStatus_saysWhatIsWrong()
{
    vr::HeadsetStatus status;
    status.reason = QStringLiteral("XR_ERROR_RUNTIME_UNAVAILABLE");
    qputenv("XR_RUNTIME_JSON", QFile::encodeName(path("none.json")));
    QVERIFY(vr::OpenXrRuntime::textOf(status).contains(path("none.json")));
    write("lib/there.so", "ELF");
    write("none.json", R"({"runtime": {"library_path": "lib/there.so"}})");
    QVERIFY(vr::OpenXrRuntime::textOf(status).startsWith("No OpenXR runtime answers"));
}

FETTLE_TEST(TestActiveRuntime, QCoreApplication)
#include "tst_active_runtime.moc"
