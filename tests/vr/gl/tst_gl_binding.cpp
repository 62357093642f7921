// Tests the binding of OpenGL to OpenXR. CMake adds a second run, in which Qt creates OpenGL contexts by EGL.
#include "tests/support/test_main.h"
#include "tests/vr/gl/connection_glx.h"
#include "tests/vr/simulator/scripted_headset.h"
#include "tests/vr/vr_test.h"

#include "vr/gl/gl_binding.h"
#include "vr/gl/gl_context.h"

class TestGlBinding : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void withoutAContextThereIsNone();
    void theCurrentContextIsTold();
    void whatTheRuntimeDoesNotTakeIsSaid();
};

void TestGlBinding::initTestCase()
{
    vr::GlContext gl;
    const bool isGlx = gl.claim() && glxProblem().isEmpty();
    gl.destroy();
    if (isGlx && qgetenv("QT_XCB_GL_INTEGRATION") == "xcb_egl")
        QSKIP("the driver's EGL does not know this display, so Qt takes GLX");
}

void TestGlBinding::withoutAContextThereIsNone()
{
    QVERIFY(!vr::currentGlBinding());
    QVERIFY(!vr::currentEglBinding());
}

void TestGlBinding::theCurrentContextIsTold()
{
    vr::GlContext gl;
    if (!gl.claim())
        QSKIP("no OpenGL 3.3 here");
    const auto binding = vr::currentGlBinding();
    QVERIFY(binding && binding->next());
    QVERIFY(!usesQtsConnection());
    QCOMPARE(QString(binding->extension()),
             QString(glxProblem().isEmpty() ? "XR_KHR_opengl_enable" : "XR_MNDX_egl_enable"));
    gl.destroy();
    QVERIFY(!vr::currentGlBinding());
}

/// Checks that an unsupported way of creating OpenGL contexts is reported. The scripted runtime supports GLX only.
void TestGlBinding::whatTheRuntimeDoesNotTakeIsSaid()
{
    ScriptedHeadset headset;
    Visitor visitor(headset);
    const bool isTaken = glxProblem().isEmpty();
    QCOMPARE(visitor.enterAndRun(), isTaken);
    QVERIFY(visitor.leave());
    QCOMPARE(visitor.reports.last().end, isTaken ? vr::HeadsetEnd::Left : vr::HeadsetEnd::NoBinding);
    QCOMPARE(visitor.reports.last().text.contains(QGuiApplication::platformName()), !isTaken);
    QCOMPARE(visitor.client->creates, isTaken ? 1 : 0);
    QCOMPARE(headset.complaints(), QString());
}

FETTLE_TEST(TestGlBinding, vr::GlxTestApplication)
#include "tst_gl_binding.moc"
