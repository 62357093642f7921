#include "tests/support/test_main.h"
#include "tests/vr/gl/offscreen_gl.h"

#include "vr/scene/label_textures.h"

using vr::LabelTextures;

class TestLabelTextures : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        m_offscreen = std::make_unique<OffscreenGl>();
        if (!m_offscreen->isUsable())
            QSKIP("no OpenGL 3.3 here");
        m_gl = m_offscreen->gl();
    }
    void init() { m_labels.create(m_gl); }
    void cleanup()
    {
        m_labels.destroy();
        QCOMPARE(m_offscreen->error(), 0U);
    }

    void oneIsPaintedAFrame();
    void longerTexts_areWiderUpToALimit();
    void whatIsNotNeeded_goes();

private:
    unsigned int textureOf(const QString& text)
    {
        m_labels.startFrame();
        return m_labels.find(text).value().texture;
    }

    std::unique_ptr<OffscreenGl> m_offscreen;
    QOpenGLExtraFunctions* m_gl = nullptr;
    LabelTextures m_labels;
};

void TestLabelTextures::oneIsPaintedAFrame()
{
    const QStringList texts{QStringLiteral("Undo"), QStringLiteral("Redo"), QStringLiteral("Save")};
    for (int frame = 1; frame < 6; ++frame) {
        m_labels.startFrame();
        int found = 0;
        for (const QString& text : texts)
            found += m_labels.find(text).has_value();
        QCOMPARE(found, std::min(frame, 3));
    }
    const unsigned int undo = textureOf(texts[0]);
    QVERIFY(m_gl->glIsTexture(undo));
    QCOMPARE(textureOf(texts[0]), undo);
    QVERIFY(textureOf(texts[1]) != undo);
}

void TestLabelTextures::longerTexts_areWiderUpToALimit()
{
    const auto aspect = [&](const QString& text) {
        m_labels.startFrame();
        return m_labels.find(text)->aspect;
    };
    QVERIFY(aspect(QStringLiteral("a")) < aspect(QStringLiteral("a longer one")));
    const QString endless(1000, QLatin1Char('w'));
    QVERIFY(aspect(endless) > 8);
    QVERIFY(aspect(endless) < 12);
}

void TestLabelTextures::whatIsNotNeeded_goes()
{
    const QString kept = QStringLiteral("kept");
    const unsigned int first = textureOf(kept);
    for (int i = 0; i < 300; ++i) {
        m_labels.startFrame();
        QCOMPARE(m_labels.find(kept).value().texture, first);
        m_labels.find(QString::number(i));
    }
    QVERIFY(m_gl->glIsTexture(first));
    const auto textures = [&] {
        int count = 0;
        for (unsigned int name = 1; name < 1000; ++name)
            count += m_gl->glIsTexture(name);
        return count;
    };
    QVERIFY(textures() > 10);
    QVERIFY(textures() < 100);
    m_labels.destroy();
    QCOMPARE(textures(), 0);
}

FETTLE_TEST(TestLabelTextures, vr::GlTestApplication)
#include "tst_label_textures.moc"
