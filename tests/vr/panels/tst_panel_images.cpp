#include "vr/panels/panel_images.h"

#include "tests/support/test_main.h"

#include <QTest>
#include <QThread>

using vr::PanelImage;
using vr::PanelImages;
using vr::PanelKind;
using vr::ToolPanel;

namespace
{
/// Shows the content in every frame until its image is ready, and returns the image.
PanelImage awaited(PanelImages& pictures, const vr::PanelContent& content, const vr::PanelTouches& touches = {})
{
    for (;;) {
        pictures.show(content, touches);
        if (const std::optional<PanelImage> picture = pictures.take(vr::kindOf(content)))
            return *picture;
        QThread::msleep(1);
    }
}

ToolPanel with(core::Tool tool)
{
    ToolPanel panel;
    panel.tool = tool;
    return panel;
}
} // namespace

class TestPanelImages : public QObject
{
    Q_OBJECT

public:
    static void initMain() { qputenv("QT_QPA_PLATFORM", "offscreen"); }

private Q_SLOTS:
    void aPicture_isWhatPaintMakes();
    void whatIsUnchanged_isNotPaintedAgain();
    void onlyThatPanel_isPainted();
    void aTouch_isANewPicture();
    void theNewest_comesLast();
    void itMayEndAnyTime();
};

void TestPanelImages::aPicture_isWhatPaintMakes()
{
    PanelImages pictures;
    const vr::PanelContent content = with(core::Tool::Smooth);
    const PanelImage picture = awaited(pictures, content);
    QVERIFY(picture.image == vr::paint(vr::layoutOf(content)));
    QVERIFY(picture.layout->kind == PanelKind::Tools && picture.layout->size == vr::layoutOf(content).size);
}

void TestPanelImages::whatIsUnchanged_isNotPaintedAgain()
{
    PanelImages pictures;
    awaited(pictures, ToolPanel());
    for (int i = 0; i < 5; ++i)
        pictures.show(ToolPanel());
    awaited(pictures, vr::NoticePanel{QStringLiteral("painted after all that was asked before")});
    QVERIFY(!pictures.take(PanelKind::Tools));
}

void TestPanelImages::onlyThatPanel_isPainted()
{
    PanelImages pictures;
    awaited(pictures, ToolPanel());
    awaited(pictures, vr::ColorPanel());
    awaited(pictures, with(core::Tool::Paint));
    QVERIFY(!pictures.take(PanelKind::Color));
}

void TestPanelImages::aTouch_isANewPicture()
{
    PanelImages pictures;
    const QImage plain = awaited(pictures, ToolPanel()).image;
    const vr::PanelTouches touches{vr::PanelTouch{core::Tool::Paint, false, 0}, std::nullopt};
    const QImage lit = awaited(pictures, ToolPanel(), touches).image;
    QVERIFY(lit != plain && lit == vr::paint(ToolPanel().layout(), touches));
    QVERIFY(awaited(pictures, ToolPanel()).image == plain);
}

/// Checks that the image of the newest content is delivered, however fast the content changes.
void TestPanelImages::theNewest_comesLast()
{
    PanelImages pictures;
    ToolPanel last;
    last.isSymmetric = true;
    const QImage wanted = vr::paint(last.layout());
    for (int i = 0; i < 200; ++i)
        pictures.show(with(static_cast<core::Tool>(i % 5)));
    for (;;)
        if (awaited(pictures, last).image == wanted)
            break;
    QTest::qWait(50);
    pictures.show(last);
    QVERIFY(!pictures.take(PanelKind::Tools));
}

void TestPanelImages::itMayEndAnyTime()
{
    for (int i = 0; i < 30; ++i) {
        PanelImages pictures;
        pictures.show(with(static_cast<core::Tool>(i % 5)));
        QThread::usleep(static_cast<unsigned long>(i) * 300);
    }
}

FETTLE_TEST(TestPanelImages, QGuiApplication)
#include "tst_panel_images.moc"
