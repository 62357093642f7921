#include "vr/openxr/xr_blending.h"

#include "tests/support/test_main.h"

#include <QTest>

#include <vector>

namespace
{
using Modes = std::vector<XrEnvironmentBlendMode>;

constexpr auto opaque = XR_ENVIRONMENT_BLEND_MODE_OPAQUE, additive = XR_ENVIRONMENT_BLEND_MODE_ADDITIVE,
               alpha = XR_ENVIRONMENT_BLEND_MODE_ALPHA_BLEND;
} // namespace

class TestXrBlending : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theRoomIsShownIfItCanBe_data();
    void theRoomIsShownIfItCanBe();
};

void TestXrBlending::theRoomIsShownIfItCanBe_data()
{
    QTest::addColumn<Modes>("offered");
    QTest::addColumn<vr::Blending>("off");
    QTest::addColumn<vr::Blending>("on");
    const auto row = [](const char* name, const Modes& offered, const vr::Blending& off, const vr::Blending& on) {
        QTest::newRow(name) << offered << off << on;
    };
    row("a Vive", {opaque}, {opaque, false}, {opaque, false});
    row("a Quest", {opaque, alpha}, {opaque, false}, {alpha, true});
    row("the room first", {alpha, opaque}, {opaque, false}, {alpha, true});
    row("alpha is better than light", {additive, opaque, alpha}, {opaque, false}, {alpha, true});
    row("opaque or light", {opaque, additive}, {opaque, false}, {additive, true});
    row("glasses", {additive}, {additive, true}, {additive, true});
    row("only alpha", {alpha}, {alpha, false}, {alpha, true});
    row("only an unknown mode", {XR_ENVIRONMENT_BLEND_MODE_MAX_ENUM}, {XR_ENVIRONMENT_BLEND_MODE_MAX_ENUM, false},
        {XR_ENVIRONMENT_BLEND_MODE_MAX_ENUM, false});
    row("nothing", {}, {opaque, false}, {opaque, false});
}

void TestXrBlending::theRoomIsShownIfItCanBe()
{
    QFETCH(Modes, offered);
    QFETCH(vr::Blending, off);
    QFETCH(vr::Blending, on);
    QVERIFY(vr::blendingOf(offered, false) == off);
    QVERIFY(vr::blendingOf(offered, true) == on);
    QCOMPARE(vr::offersPassthrough(offered), on.hasPassthrough);
}

FETTLE_TEST(TestXrBlending)
#include "tst_xr_blending.moc"
