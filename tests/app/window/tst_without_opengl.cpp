#include "tests/support/program_driver.h"
#include "tests/support/test_main.h"

#include "core/io/mesh_io.h"
#include "ui/scene/scene.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace app;

/// Where there is no OpenGL 3.3 the window has no view; documents open and are saved as elsewhere.
class TestWithoutOpenGl : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void saving_keepsReferenceImages();
};

void TestWithoutOpenGl::saving_keepsReferenceImages()
{
    QVERIFY(!ui::graphicsProblem().isEmpty());
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("ball.glb"));
    const core::SavedReference front{
        "front", std::filesystem::path(path.toStdString()).parent_path() / "front.png", 40, 3, 5, 0.5, true};
    core::WriteOptions options;
    options.metadata.references = {front};
    core::writeMesh(path.toStdString(), core::icosphere(3, 30), options);

    Program program;
    program.window.show();
    Q_EMIT program.window.files()->openRequested(path);
    QTRY_COMPARE(program.document.modelInfo().path, path);
    QTRY_VERIFY(!program.document.job().isBusy());

    const QString copy = folder.filePath(QStringLiteral("copy.glb"));
    QSignalSpy saved(&program.document.saver(), &ModelSaver::saved);
    Q_EMIT program.window.files()->saveRequested(copy);
    QTRY_COMPARE(saved.size(), 1);
    QCOMPARE(core::readMetadata(copy.toStdString()).references, std::vector{front});
}

static int withoutOpenGl(int argc, char* argv[])
{
    qputenv("QT_XCB_GL_INTEGRATION", "none");
    return test::run<TestWithoutOpenGl, OnScreen>(argc, argv);
}

FETTLE_TEST_MAIN(TestWithoutOpenGl, withoutOpenGl)
#include "tst_without_opengl.moc"
