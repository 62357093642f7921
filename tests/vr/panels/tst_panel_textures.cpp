#include "vr/panels/panel_textures.h"

#include <QTest>
#include <QThread>

using vr::PanelKind;
using vr::PanelPicture;
using vr::PanelPictures;
using vr::ToolPanel;

namespace
{
/// As frames ask: until it is there.
PanelPicture awaited(PanelPictures& pictures, const vr::PanelContent& content, const vr::PanelTouches& touches = {})
{
    for (;;) {
        pictures.show(content, touches);
        if (const std::optional<PanelPicture> picture = pictures.take(vr::kindOf(content)))
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

class TestPanelPictures : public QObject
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

void TestPanelPictures::aPicture_isWhatPaintMakes()
{
    PanelPictures pictures;
    const vr::PanelContent content = with(core::Tool::Smooth);
    const PanelPicture picture = awaited(pictures, content);
    QVERIFY(picture.image == vr::paint(vr::layoutOf(content)));
    QVERIFY(picture.layout->kind == PanelKind::Tools && picture.layout->size == vr::layoutOf(content).size);
}

void TestPanelPictures::whatIsUnchanged_isNotPaintedAgain()
{
    PanelPictures pictures;
    awaited(pictures, ToolPanel());
    for (int i = 0; i < 5; ++i)
        pictures.show(ToolPanel());
    awaited(pictures, vr::Notice{QStringLiteral("painted after all that was asked before")});
    QVERIFY(!pictures.take(PanelKind::Tools));
}

void TestPanelPictures::onlyThatPanel_isPainted()
{
    PanelPictures pictures;
    awaited(pictures, ToolPanel());
    awaited(pictures, vr::ColorPanel());
    awaited(pictures, with(core::Tool::Paint));
    QVERIFY(!pictures.take(PanelKind::Color));
}

void TestPanelPictures::aTouch_isANewPicture()
{
    PanelPictures pictures;
    const QImage plain = awaited(pictures, ToolPanel()).image;
    const vr::PanelTouches touches{vr::PanelTouch{core::Tool::Paint, false, 0}, std::nullopt};
    const QImage lit = awaited(pictures, ToolPanel(), touches).image;
    QVERIFY(lit != plain && lit == vr::paint(ToolPanel().layout(), touches));
    QVERIFY(awaited(pictures, ToolPanel()).image == plain);
}

/// However fast it changes.
void TestPanelPictures::theNewest_comesLast()
{
    PanelPictures pictures;
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

void TestPanelPictures::itMayEndAnyTime()
{
    for (int i = 0; i < 30; ++i) {
        PanelPictures pictures;
        pictures.show(with(static_cast<core::Tool>(i % 5)));
        QThread::usleep(static_cast<unsigned long>(i) * 300);
    }
}

QTEST_MAIN(TestPanelPictures)
#include "tst_panel_textures.moc"
