#include "vr/openxr/xr_result.h"

#include "tests/support/test_main.h"

#include <QTest>

using vr::XrError;

class TestXrResult : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void resultsHaveNames()
    {
        QCOMPARE(vr::resultName(XR_ERROR_INSTANCE_LOST), QString("XR_ERROR_INSTANCE_LOST"));
        QCOMPARE(vr::resultName(XR_SESSION_NOT_FOCUSED), QString("XR_SESSION_NOT_FOCUSED"));
        QCOMPARE(vr::resultName(static_cast<XrResult>(-98765)), QString("XrResult -98765"));
    }

    void onlyErrorsAreThrown()
    {
        QCOMPARE(vr::check(XR_SESSION_NOT_FOCUSED, "xrSyncActions"), XR_SESSION_NOT_FOCUSED);
        try {
            vr::check(XR_ERROR_SESSION_LOST, "xrWaitFrame");
            QFAIL("not thrown");
        } catch (const XrError& error) {
            QCOMPARE(error.result(), XR_ERROR_SESSION_LOST);
            QCOMPARE(error.text(), QString("xrWaitFrame: XR_ERROR_SESSION_LOST"));
        }
    }

    void listsMayGrowMeanwhile()
    {
        std::uint32_t offered = 2;
        const auto items =
            vr::enumerate("xrEnumerateThings", 0, [&](std::uint32_t capacity, std::uint32_t* count, int* to) {
                *count = offered;
                if (capacity == 0)
                    return XR_SUCCESS;
                if (capacity == 2)
                    offered = *count = 3;
                if (capacity < *count)
                    return XR_ERROR_SIZE_INSUFFICIENT;
                for (std::uint32_t i = 0; i < *count; ++i)
                    to[i] = static_cast<int>(i) + 1;
                return XR_SUCCESS;
            });
        QCOMPARE(items, (std::vector<int>{1, 2, 3}));
    }

    /// Checks that a list that never fits throws an error instead of being queried for ever.
    void listsThatNeverFitAreRefused()
    {
        const auto ask = [](std::uint32_t capacity, std::uint32_t* count, int*) {
            *count = capacity + 1;
            return capacity == 0 ? XR_SUCCESS : XR_ERROR_SIZE_INSUFFICIENT;
        };
        QVERIFY_EXCEPTION_THROWN(vr::enumerate("xrEnumerateThings", 0, ask), vr::XrError);
    }

    void emptyListsAreNotAskedForTwice()
    {
        int asked = 0;
        const auto items = vr::enumerate("xrEnumerateThings", 0, [&](std::uint32_t, std::uint32_t* count, int*) {
            ++asked;
            *count = 0;
            return XR_SUCCESS;
        });
        QVERIFY(items.empty());
        QCOMPARE(asked, 1);
    }
};

FETTLE_TEST(TestXrResult, QCoreApplication)
#include "tst_xr_result.moc"
