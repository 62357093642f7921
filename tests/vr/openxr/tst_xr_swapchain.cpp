#include "vr/openxr/xr_swapchain.h"

#include "tests/support/test_main.h"

#include <QTest>

#include <qopengl.h>

#include <vector>

using Formats = std::vector<std::int64_t>;

class TestXrSwapchain : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void srgbIsBest()
    {
        QCOMPARE(vr::bestFormat(Formats{GL_RGBA8, GL_DEPTH_COMPONENT24, GL_RGBA16F, GL_SRGB8_ALPHA8})->name,
                 GL_SRGB8_ALPHA8);
        QVERIFY(vr::bestFormat(Formats{GL_SRGB8_ALPHA8})->isSrgb);
    }

    void linearLightWantsManyBits()
    {
        const auto format = vr::bestFormat(Formats{GL_RGBA8, GL_RGB10_A2, GL_RGBA16F});
        QCOMPARE(format->name, GL_RGBA16F);
        QVERIFY(!format->isSrgb);
        QCOMPARE(vr::bestFormat(Formats{GL_RGBA8})->name, GL_RGBA8);
    }

    void whatHasNoColourIsNone()
    {
        QVERIFY(!vr::bestFormat(Formats{}));
        QVERIFY(!vr::bestFormat(Formats{GL_DEPTH_COMPONENT24, 4711}));
    }
};

FETTLE_TEST(TestXrSwapchain, QCoreApplication)
#include "tst_xr_swapchain.moc"
