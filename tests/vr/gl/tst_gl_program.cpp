#include "tests/support/test_main.h"
#include "tests/vr/gl/offscreen_gl.h"
#include "vr/gl/gl_program.h"

class TestGlProgram : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void create_data();
    void create();
};

void TestGlProgram::create_data()
{
    QTest::addColumn<QByteArray>("vertexFile");
    QTest::addColumn<QByteArray>("fragmentFile");
    QTest::addColumn<bool>("isCreated");
    QTest::newRow("both") << QByteArray("clay.vert") << QByteArray("clay.frag") << true;
    QTest::newRow("no fragment shader") << QByteArray("clay.vert") << QByteArray("none.frag") << false;
    QTest::newRow("no vertex shader") << QByteArray("none.vert") << QByteArray("clay.frag") << false;
    QTest::newRow("the fragment shader does not compile")
        << QByteArray("clay.vert") << QByteArray("clay.vert") << false;
}

void TestGlProgram::create()
{
    QFETCH(QByteArray, vertexFile);
    QFETCH(QByteArray, fragmentFile);
    const OffscreenGl offscreen;
    if (!offscreen.isUsable())
        QSKIP("no OpenGL 3.3 here");
    vr::Program program;
    QTEST(program.create(offscreen.gl(), vertexFile, fragmentFile), "isCreated");
    program.destroy();
}

FETTLE_TEST(TestGlProgram, vr::GlTestApplication)
#include "tst_gl_program.moc"
