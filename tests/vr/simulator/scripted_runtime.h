#pragma once

#include <QByteArray>
#include <QImage>
#include <QJsonObject>
#include <QStringList>

/// The OpenXR runtime of vr/simulator, loaded into the test's process and controlled by the test. Its commands are
/// described in vr/simulator/control_api.h; an unknown command ends the test. Thread: any.
class ScriptedRuntime
{
public:
    /// Restarts the runtime. Precondition: no OpenXR instance exists. Log and images are written to the paths in
    /// FETTLE_XR_LOG and FETTLE_XR_FRAMES.
    explicit ScriptedRuntime(const QByteArray& script = "{}");

    /// Makes the OpenXR loader choose this runtime from now on, here and in child processes. The runtime follows the
    /// script in FETTLE_XR_SCRIPT unless another was loaded.
    static void choose();
    /// Loads a script. Returns its error, or an empty text if it is now used.
    static QString load(const QByteArray& script);

    /// Executes a step immediately: the next frame is affected.
    void set(const QByteArray& step);
    /// Waits until the client has ended this many more frames; at pace "stepped" it releases them first.
    bool frames(int count);
    QJsonObject report() const;
    /// Returns the left eye's image of the newest frame since the last call, and requests the next image; null: no new
    /// image.
    QImage picture();
    /// Errors and warnings about the client. Both are empty for a correct client.
    QStringList clientErrors() const;
    QStringList clientWarnings() const;
};

/// Returns the complaints that OpenXR's validation layer has written to a file, one per line. Empty if there is no
/// file, or if the file contains only the reports of newer layers about their own start and end.
QStringList layerComplaints(const QString& path);

/// Returns a script with the fastest pace.
inline QByteArray fastScript()
{
    return R"({"start": {"pace": "fast", "size": [64, 48]}})";
}

/// Returns a script with the fastest pace, tiny images and these steps.
inline QByteArray fastWith(const QByteArray& steps)
{
    return R"({"start": {"pace": "fast", "size": [16, 16]}, "steps": [)" + steps + "]}";
}
