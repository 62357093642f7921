#pragma once

#include <QByteArray>
#include <QImage>
#include <QJsonObject>
#include <QStringList>

/// The OpenXR runtime of vr/simulator, in the process of the test: the loader takes it from now on, and the test steers
/// it. The words are in vr/simulator/control_api.h; a word that is not understood ends the test. Any thread.
class ScriptedRuntime
{
public:
    /// Begins anew; no instance may exist. Log and pictures go where FETTLE_XR_LOG and FETTLE_XR_FRAMES say.
    explicit ScriptedRuntime(const QByteArray& script = "{}");

    /// The loader takes it from now on, here and in processes that are started from here. It does what FETTLE_XR_SCRIPT
    /// says, unless one was loaded.
    static void choose();
    /// What is wrong with a script; empty: it is in force.
    static QString load(const QByteArray& script);

    /// Does a step now: the next frame sees it.
    void set(const QByteArray& step);
    /// Waits until the client has ended so many more frames; at pace "stepped" they go only now.
    bool frames(int count);
    QJsonObject report() const;
    /// What the left eye saw in the newest frame since this was last asked, which asks for the next; null: nothing new.
    QImage picture();
    /// Both must be empty of a client that knows the rules.
    QStringList clientErrors() const;
    QStringList clientWarnings() const;
};

/// The fastest pace.
inline QByteArray fastScript()
{
    return R"({"start": {"pace": "fast", "size": [64, 48]}})";
}

/// The fastest pace, with tiny pictures and such steps.
inline QByteArray fastWith(const QByteArray& steps)
{
    return R"({"start": {"pace": "fast", "size": [16, 16]}, "steps": [)" + steps + "]}";
}
