#pragma once

#include "vr/simulator/call_log.h"
#include "vr/simulator/handles.h"
#include "vr/simulator/picture.h"
#include "vr/simulator/script.h"
#include "vr/simulator/simulated_world.h"

#include <condition_variable>
#include <mutex>
#include <optional>

namespace simulator
{
class Instance;
class Session;

/// The floor moves, or the place that counts as the middle.
struct Recentring
{
    XrReferenceSpaceType space = XR_REFERENCE_SPACE_TYPE_LOCAL;
    vr::Pose origin;        ///< the new one, in the room
    std::int64_t after = 0; ///< frames from the event to the change
};

/// All there is, once in a process; it stays when the loader lets go of the library, so that a client may come again.
/// One mutex guards it: every call into the runtime and every word of the control holds it, but while it waits.
class Runtime
{
public:
    static Runtime& get();

    /// Begins anew with a script and the files that the environment names. Throws std::exception.
    void load(const std::string& script);
    /// With the script that the environment names, unless one was loaded.
    void loadOnce();
    void apply(const ScriptStep& step);

    /// The number that the session's next frame will have; 0 without a session.
    std::int64_t nextFrame() const;
    void recentre(const Recentring& recentring);
    void loseSession(std::int64_t afterFrames);
    void loseInstance(std::int64_t afterFrames);
    /// What was foretold, if it is time.
    void loseIfDue();
    void exitSession();

    nlohmann::json report() const;

    std::mutex mutex;
    std::condition_variable changed; ///< anything that somebody may wait for
    SimulatedWorld world;
    Script script;
    CallLog log;
    Handles handles;
    std::shared_ptr<Instance> instance; ///< one at a time
    std::shared_ptr<Session> session;   ///< one at a time
    std::int64_t sessionsMade = 0;
    std::int64_t framesEnded = 0;   ///< ever
    std::int64_t framesAllowed = 0; ///< of pace Stepped
    bool isClientWaiting = false;   ///< for a frame to be allowed
    bool isClientFrozen = false;    ///< in a call that does not return
    std::string pictureFolder;      ///< empty: none are kept
    bool isPictureWanted = false;   ///< of the next frame, to be shown
    std::optional<Picture> picture; ///< the newest that was wanted

private:
    Runtime() = default;
    bool m_isLoaded = false;
};
} // namespace simulator
