// Tests of the OpenXR versions that the simulator accepts from a loader and from a client.
#include "vr/simulator/loader_interface.h"

#include "tests/support/test_main.h"

#include <QLibrary>
#include <QTest>

#include <cstring>

namespace
{
using Negotiate = XrResult (*)(const simulator::LoaderInfo*, simulator::RuntimeRequest*);

/// Returns the information that a loader with this range of versions passes.
simulator::LoaderInfo loaderInfo(XrVersion least, XrVersion most)
{
    return {simulator::LoaderStructure::LoaderInfo, 1, sizeof(simulator::LoaderInfo), 1, 1, least, most};
}

simulator::RuntimeRequest emptyRequest()
{
    return {simulator::LoaderStructure::RuntimeRequest, 1, sizeof(simulator::RuntimeRequest), 0, 0, nullptr};
}

XrInstanceCreateInfo createInfo(XrVersion version)
{
    XrInstanceCreateInfo info{};
    info.type = XR_TYPE_INSTANCE_CREATE_INFO;
    std::strncpy(info.applicationInfo.applicationName, "Version test", XR_MAX_APPLICATION_NAME_SIZE - 1);
    info.applicationInfo.apiVersion = version;
    return info;
}
} // namespace

class TestVersions : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void loader_isAnsweredWith10_data();
    void loader_isAnsweredWith10();
    void client_mustAskFor10_data();
    void client_mustAskFor10();

private:
    template <class Function> Function function(XrInstance instance, const char* name) const;

    Negotiate m_negotiate = nullptr;
    simulator::RuntimeRequest m_runtime = emptyRequest();
};

template <class Function> Function TestVersions::function(XrInstance instance, const char* name) const
{
    PFN_xrVoidFunction found = nullptr;
    m_runtime.getInstanceProcAddr(instance, name, &found);
    return reinterpret_cast<Function>(found);
}

void TestVersions::initTestCase()
{
    QLibrary library(QStringLiteral(FETTLE_XR_LIBRARY));
    m_negotiate = reinterpret_cast<Negotiate>(library.resolve("xrNegotiateLoaderRuntimeInterface"));
    QVERIFY2(m_negotiate, qPrintable(library.errorString()));
    const simulator::LoaderInfo info = loaderInfo(XR_MAKE_VERSION(1, 0, 0), XR_MAKE_VERSION(1, 0x3ff, 0xfff));
    QCOMPARE(m_negotiate(&info, &m_runtime), XR_SUCCESS);
}

void TestVersions::loader_isAnsweredWith10_data()
{
    QTest::addColumn<quint64>("least");
    QTest::addColumn<quint64>("most");
    QTest::addColumn<bool>("accepted");
    QTest::newRow("1.0") << quint64(XR_MAKE_VERSION(1, 0, 0)) << quint64(XR_MAKE_VERSION(1, 0, 0xfff)) << true;
    QTest::newRow("every 1") << quint64(XR_MAKE_VERSION(1, 0, 0)) << quint64(XR_MAKE_VERSION(1, 0x3ff, 0xfff)) << true;
    QTest::newRow("from 1.1 on") << quint64(XR_MAKE_VERSION(1, 1, 0)) << quint64(XR_MAKE_VERSION(1, 0x3ff, 0xfff))
                                 << false;
    QTest::newRow("before 1.0") << quint64(XR_MAKE_VERSION(0, 90, 0)) << quint64(XR_MAKE_VERSION(0, 90, 1)) << false;
}

void TestVersions::loader_isAnsweredWith10()
{
    QFETCH(quint64, least);
    QFETCH(quint64, most);
    QFETCH(bool, accepted);
    const simulator::LoaderInfo info = loaderInfo(least, most);
    simulator::RuntimeRequest request = emptyRequest();
    QCOMPARE(m_negotiate(&info, &request) == XR_SUCCESS, accepted);
    if (!accepted)
        return;
    QCOMPARE(int(XR_VERSION_MAJOR(request.apiVersion)), 1);
    QCOMPARE(int(XR_VERSION_MINOR(request.apiVersion)), 0);
}

void TestVersions::client_mustAskFor10_data()
{
    QTest::addColumn<quint64>("version");
    QTest::addColumn<int>("result");
    QTest::newRow("1.0.0") << quint64(XR_MAKE_VERSION(1, 0, 0)) << int(XR_SUCCESS);
    QTest::newRow("1.0.20") << quint64(XR_MAKE_VERSION(1, 0, 20)) << int(XR_SUCCESS);
    QTest::newRow("1.0.4095") << quint64(XR_MAKE_VERSION(1, 0, 4095)) << int(XR_SUCCESS);
    QTest::newRow("0.90") << quint64(XR_MAKE_VERSION(0, 90, 0)) << int(XR_ERROR_API_VERSION_UNSUPPORTED);
    QTest::newRow("1.1.0") << quint64(XR_MAKE_VERSION(1, 1, 0)) << int(XR_ERROR_API_VERSION_UNSUPPORTED);
    QTest::newRow("1.1.47") << quint64(XR_MAKE_VERSION(1, 1, 47)) << int(XR_ERROR_API_VERSION_UNSUPPORTED);
    QTest::newRow("2.0") << quint64(XR_MAKE_VERSION(2, 0, 0)) << int(XR_ERROR_API_VERSION_UNSUPPORTED);
}

void TestVersions::client_mustAskFor10()
{
    QFETCH(quint64, version);
    QFETCH(int, result);
    const auto create = function<PFN_xrCreateInstance>(XR_NULL_HANDLE, "xrCreateInstance");
    QVERIFY(create);
    const XrInstanceCreateInfo info = createInfo(version);
    XrInstance instance = XR_NULL_HANDLE;
    QCOMPARE(int(create(&info, &instance)), result);
    if (instance != XR_NULL_HANDLE)
        QCOMPARE(function<PFN_xrDestroyInstance>(instance, "xrDestroyInstance")(instance), XR_SUCCESS);
}

FETTLE_TEST(TestVersions, QCoreApplication)
#include "tst_versions.moc"
