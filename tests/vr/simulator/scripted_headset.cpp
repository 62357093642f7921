#include "tests/vr/simulator/scripted_headset.h"
#include "tests/support/effort.h"

#include <QColor>
#include <QFile>
#include <QJsonObject>
#include <QOpenGLExtraFunctions>
#include <QTest>

namespace
{
constexpr GLenum framebufferSrgb = 0x8DB9;
constexpr const char* layers = "XR_ENABLE_API_LAYERS";
constexpr const char* validation = "XR_APILAYER_LUNARG_core_validation";

QByteArray json(const char* words)
{
    return QByteArray(words).replace('\'', '"');
}
} // namespace

QColor RecordingClient::linear(std::size_t eye)
{
    return eye == 0 ? QColor::fromRgbF(0.5F, 0.1F, 0) : QColor::fromRgbF(0, 0.1F, 0.5F);
}

bool RecordingClient::create(QOpenGLContext& made)
{
    ++creates;
    context = &made;
    thread = std::this_thread::get_id();
    made.functions()->glGenFramebuffers(1, &m_framebuffer);
    return canDraw;
}

vr::FrameOutput RecordingClient::frame(const vr::FrameInput& input)
{
    ++frames;
    moves += input.roomMoved ? 1 : 0;
    const std::lock_guard lock(m_mutex);
    m_last = {input.wands, input.head, input.displayNs, input.hasFocus, input.roomMoved, input.offersPassthrough,
              input.joints};
    m_images.clear();
    m_views.clear();
    return std::exchange(m_answer, {});
}

void RecordingClient::draw(std::size_t eye, const vr::EyeImage& image, const vr::EyeView& view)
{
    ++draws;
    auto* gl = QOpenGLContext::currentContext()->extraFunctions();
    const QColor color = linear(eye);
    gl->glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
    gl->glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, image.texture, 0);
    gl->glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, image.depthTexture, 0);
    gl->glViewport(0, 0, image.width, image.height);
    gl->glDisable(GL_SCISSOR_TEST);
    gl->glEnable(framebufferSrgb);
    gl->glClearColor(color.redF(), color.greenF(), color.blueF(), 1);
    gl->glDepthMask(GL_TRUE);
    gl->glClearDepthf(static_cast<float>(depth(eye)));
    m_clock.run([gl] { gl->glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT); });
    glErrors += gl->glGetError() == GL_NO_ERROR ? 0 : 1;
    gl->glBindFramebuffer(GL_FRAMEBUFFER, 0);
    const std::lock_guard lock(m_mutex);
    m_images.push_back(image);
    m_views.push_back(view);
}

void RecordingClient::destroy()
{
    ++destroys;
    if (std::this_thread::get_id() != thread || QOpenGLContext::currentContext() != context)
        qFatal("destroyed on another thread, or without its context");
    QOpenGLContext::currentContext()->functions()->glDeleteFramebuffers(1, &m_framebuffer);
}

void RecordingClient::answer(const vr::FrameOutput& output)
{
    const std::lock_guard lock(m_mutex);
    m_answer = output;
}

SeenFrame RecordingClient::last() const
{
    const std::lock_guard lock(m_mutex);
    return m_last;
}

std::vector<vr::EyeImage> RecordingClient::images() const
{
    const std::lock_guard lock(m_mutex);
    return m_images;
}

std::vector<vr::EyeView> RecordingClient::views() const
{
    const std::lock_guard lock(m_mutex);
    return m_views;
}

ScriptedHeadset::ScriptedHeadset()
{
    qputenv(layers, validation);
    qputenv("XR_CORE_VALIDATION_EXPORT_TYPE", "text");
    qputenv("XR_CORE_VALIDATION_FILE_NAME", m_folder.filePath("validation.txt").toUtf8());
    qputenv("FETTLE_XR_FRAMES", m_folder.path().toUtf8());
}

std::shared_ptr<void> ScriptedHeadset::withoutLayer() const
{
    qunsetenv(layers);
    return {nullptr, [](void*) { qputenv(layers, validation); }};
}

void ScriptedHeadset::load(const char* script)
{
    QFile::remove(m_folder.filePath("validation.txt"));
    if (const QString wrong = ScriptedRuntime::load(json(script)); !wrong.isEmpty())
        qFatal("%s: %s", script, qPrintable(wrong));
}

void ScriptedHeadset::step(const char* step)
{
    m_runtime.set(json(step));
}

bool ScriptedHeadset::frames(int count)
{
    return m_runtime.frames(count);
}

int ScriptedHeadset::calls(const char* name) const
{
    return report()["calls"].toObject()[QLatin1StringView(name)].toInt();
}

QString ScriptedHeadset::complaints() const
{
    const QStringList all =
        m_runtime.clientErrors() + m_runtime.clientWarnings() + layerComplaints(m_folder.filePath("validation.txt"));
    return all.join('\n');
}

QImage ScriptedHeadset::picture(int session, int frame, const char* eye) const
{
    return QImage(m_folder.filePath(
        QStringLiteral("session%1_frame%2_%3.png").arg(session).arg(frame, 4, 10, QChar('0')).arg(eye)));
}

Visitor::Visitor(ScriptedHeadset& headset, std::chrono::milliseconds exitTimeout)
    : thread(exitTimeout)
    , m_headset(headset)
{
    QObject::connect(&thread, &vr::HeadsetThread::reported, &thread,
                     [this](const vr::HeadsetReport& report) { reports << report; });
}

Visitor::~Visitor()
{
    m_headset.step("{'pace': 'fast', 'freeze': ''}");
}

bool Visitor::enter()
{
    reports.clear();
    return thread.enter(client);
}

bool Visitor::enterAndRun()
{
    return enter() && waitFor(vr::HeadsetStage::Running);
}

bool Visitor::leave()
{
    thread.leave();
    return waitForEnd();
}

bool Visitor::waitForEnd()
{
    return waitFor(vr::HeadsetStage::Ended);
}

bool Visitor::waitFor(vr::HeadsetStage stage)
{
    const auto isOver = [&] {
        return !reports.isEmpty() && (reports.last().stage == stage || reports.last().isEnded());
    };
    return QTest::qWaitFor(isOver, longestWait) && reports.last().stage == stage;
}
