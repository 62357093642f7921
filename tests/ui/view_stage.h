#pragma once

#include "core/mesh/dirty_slots.h"
#include "core/mesh/mesh_builder.h"
#include "tests/ui/ui_test.h"
#include "ui/actions/actions.h"
#include "ui/viewport/viewport.h"

#include <QMainWindow>

#include <utility>

namespace ui
{
/// A window with a ball of radius 30 about the origin, seen from the front without perspective, for tests of a tool in
/// the view.
struct ViewStage
{
    explicit ViewStage(int subdivisions) : mesh(core::buildMesh(core::icosphere(subdivisions, 30)).mesh)
    {
        window.setCentralWidget(viewport);
        window.resize(700, 560);
        viewport->setPatchSource([this] { return std::exchange(next, std::nullopt); });
        viewport->setReducesMotion(true);
        actions.get(QStringLiteral("edit.stop"))->setEnabled(false); // as while nothing runs
        viewport->showModel({core::Vec3::Constant(-30), core::Vec3::Constant(30)});
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        viewport->navigation()->turnTo(OrbitCamera::Side::Front);
        viewport->navigation()->setProjection(OrbitCamera::Projection::Orthographic);
        showMesh();
    }

    QPoint at(const core::Vec3& point) const
    {
        const OrbitCamera::Pixel p = viewport->camera().project(point);
        return QPointF(p.x(), p.y()).toPoint();
    }

    void press(const QPoint& p, Qt::KeyboardModifiers keys = {}, Qt::MouseButton button = Qt::LeftButton)
    {
        hover(p);
        sendMouse(viewport, QEvent::MouseButtonPress, p, button, keys);
    }
    void doubleClick(const QPoint& p)
    {
        press(p);
        release(p);
        sendMouse(viewport, QEvent::MouseButtonDblClick, p, Qt::LeftButton);
        release(p);
    }
    void hover(const QPoint& p) { send(QEvent::MouseMove, p, Qt::NoButton, Qt::NoButton); }
    void move(const QPoint& p, Qt::KeyboardModifiers keys = {})
    {
        send(QEvent::MouseMove, p, Qt::NoButton, Qt::LeftButton, keys);
    }
    void release(const QPoint& p) { send(QEvent::MouseButtonRelease, p, Qt::LeftButton, Qt::NoButton); }
    void drag(const QPoint& from, const QPoint& by, Qt::KeyboardModifiers keys = {})
    {
        press(from, keys);
        for (int i = 1; i <= 10; ++i)
            move(from + by * i / 10, keys);
        release(from + by);
    }

    void showMesh()
    {
        const quint64 before = viewport->stats().patches;
        next = core::wholePatchOf(*mesh);
        viewport->patchReady();
        QTRY_COMPARE(viewport->stats().patches, before + 1);
    }
    QImage picture()
    {
        const quint64 frames = viewport->stats().frames;
        viewport->update();
        while (viewport->stats().frames == frames)
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 100);
        return viewport->grabFramebuffer();
    }

    QMainWindow window;
    Actions actions{&window};
    BrushSettings brush;
    Viewport* viewport = new Viewport(&brush);
    std::unique_ptr<core::Mesh> mesh;
    std::optional<core::MeshPatch> next;

private:
    void send(QEvent::Type type, const QPoint& p, Qt::MouseButton button, Qt::MouseButtons held,
              Qt::KeyboardModifiers keys = {})
    {
        QMouseEvent event(type, p, viewport->mapToGlobal(p), button, held, keys);
        QCoreApplication::sendEvent(viewport, &event);
    }
};
} // namespace ui
