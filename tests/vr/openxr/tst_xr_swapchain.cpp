#include "vr/openxr/xr_swapchain.h"

#include "tests/support/test_main.h"

#include <QTest>

#include <qopengl.h>

#include <algorithm>
#include <vector>

using Formats = std::vector<std::int64_t>;

namespace
{
Formats namesOf(const std::vector<vr::ImageFormat>& formats)
{
    Formats names;
    for (const vr::ImageFormat& format : formats)
        names.push_back(format.name);
    return names;
}
} // namespace

class TestXrSwapchain : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void srgbIsBest()
    {
        QCOMPARE(namesOf(vr::usableFormats(Formats{GL_RGBA8, GL_DEPTH_COMPONENT24, GL_RGBA16F, GL_SRGB8_ALPHA8})),
                 Formats({GL_SRGB8_ALPHA8, GL_RGBA16F, GL_RGBA8}));
        QVERIFY(vr::usableFormats(Formats{GL_SRGB8_ALPHA8}).front().isSrgb);
    }

    void linearLightWantsManyBits()
    {
        const std::vector<vr::ImageFormat> formats = vr::usableFormats(Formats{GL_RGBA8, GL_RGB10_A2, GL_RGBA16F});
        QCOMPARE(namesOf(formats), Formats({GL_RGBA16F, GL_RGB10_A2, GL_RGBA8}));
        QVERIFY(std::ranges::none_of(formats, &vr::ImageFormat::isSrgb));
    }

    void whatHasNoColourIsNone()
    {
        QVERIFY(vr::usableFormats(Formats{}).empty());
        QVERIFY(vr::usableFormats(Formats{GL_DEPTH_COMPONENT24, 4711}).empty());
    }

    void depthWantsManyBits()
    {
        const std::vector<vr::ImageFormat> formats = vr::usableDepthFormats(
            Formats{GL_SRGB8_ALPHA8, GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT24});
        QCOMPARE(namesOf(formats), Formats({GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT32F}));
        QVERIFY(std::ranges::all_of(formats, &vr::ImageFormat::isDepth));
    }
};

FETTLE_TEST(TestXrSwapchain, QCoreApplication)
#include "tst_xr_swapchain.moc"
