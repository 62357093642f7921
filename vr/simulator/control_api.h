#pragma once

#include <cstdint>

// clang-format off
/// Controls the simulated runtime: by a script that the environment names, or through the functions below, which a test
/// or the simulator's window finds by dlsym() in the client's process. All use JSON with the same vocabulary.
///
///     FETTLE_XR_SCRIPT    path of a script; none: a headset that does not move
///     FETTLE_XR_LOG       path of a log to write, one object per line: {"call", "result", "session", "frame", ...},
///                         {"ended_frame"}, {"haptic"}, {"client_error"}, {"client_warning"}
///     FETTLE_XR_FRAMES    folder for pictures: session0_frame0012_left.png, _right, _mono, _quad0 ...
///
/// A script: {"start": STEP, "steps": [STEP with "frame": n and perhaps "session": n, ...]}. Frames count from 0 in
/// each session, sessions from 0 after each load; a step without "session" belongs to the first session. A step takes
/// effect when the client waits for its frame, which is the first to show it. The display time advances by exactly one
/// period per frame, so that every run is the same. Unless something prevents it, a session is to render from frame 2
/// on and has the focus from frame 3 on. All members of a STEP are optional:
///
///     "over": n                     movements of this step take n frames instead of happening at once
///     "head": {"position": [x,y,z], "rotation": [x,y,z,w] or "yaw_pitch_roll": [degrees],
///         "tracked": true|false|"rotation"|"no_position"}
///     "left", "right": as "head", and "on", "trigger", "squeeze", "pad": [x,y], "pad_touch", "pad_press",
///         "stick": [x,y], "stick_press", "menu", "button_a", "button_b", and of bare hands "pinch", "grasp":
///         numbers, or true and false
///     "aim": {"position", "rotation"}   pose of the wands' aim relative to their grips
///     "pinch_at": {"position", "rotation"}   pose between thumb and index finger of bare hands, relative to the grips
///     "profile": path               interaction profile of the wands
///     "size": [w,h], "eye_distance", "views": "stereo"|"mono"|"mono_first"
///     "fov": [left,right,up,down]   angles of the left eye, degrees
///     "hidden": share               fraction of a picture's sides that the lens hides at each corner
///     "hz", "rates": [hz]           refresh rate of the display, and other rates that it can have
///     "stage": bool, "local_floor": bool, "bounds": [w,d]|null
///     "runtime", "headset", "opengl": bool   whether each is available, for queries from now on
///     "extensions": bool            whether extensions other than OpenGL's are offered
///     "withheld": [names]           extensions that are not offered
///     "failing_formats": ["srgb8_alpha8"|"rgba16f"|"rgba8"|"depth24"|"depth32f"]   offered, but no images are made
///     "api_minors": [n]             minor versions of OpenXR 1 that a client may ask for
///     "blend_modes": ["opaque"|"additive"|"alpha_blend"]   ways to combine pictures with the real room, a plain wall
///     "least_opengl": [major,minor]
///     "pace": "real"|"live"|"fast"|"stepped"   live: the display time is the clock's; else it waits for a slow client
///     "worn", "visible", "focus", "should_render": bool
///     "exit": true                  asks the session to stop for good
///     "late_ms": n                  the frame is n ms late, its display time by n ms rounded up to whole periods
///     "recentre": {"space": "local"|"stage", "position", "rotation", "after": n}   the space's new origin in the room
///     "lose_session": n, "lose_instance": n   announced now, lost n frames later
///     "lose_events": true           discards the waiting events, except changes of a session's state
///     "fail": {"call": name, "result": XrResult's name, "times": n, "after": n}   answers the call with this result,
///                               n times, after that number of calls was answered normally
///     "freeze": name                the named call does not return until another name, or "", is given
///     "wake_at_exit": true          the frozen call returns when the process ends by exit(), which then waits a moment
///     "keep": true|[frames], "keep_every": n   frames whose pictures are kept; true: the next frame
///     "watch_drawing": bool         destroying a swapchain whose images are still drawn on is an error of the client
///
/// Poses are in the room: metres, Y up, the floor at y = 0. A wand's pose is its grip.
///
/// Thread: any. A returned text is valid until the thread's next call.
// clang-format on
extern "C" {
/// Resets the simulator to the start of a script. The log and the picture folder that the environment names are opened
/// again. Returns null, or what is wrong.
const char* fettle_xr_load(const char* script);
/// Executes a step now: the next frame shows it. Returns null, or what is wrong.
const char* fettle_xr_do(const char* step);
/// Waits until `count` more frames have ended. With pace "stepped" it allows these frames, and waits also until the
/// client waits for the next frame or has stopped. Returns how many frames ended, which is fewer if `milliseconds` were
/// not enough.
int fettle_xr_frames(int count, int milliseconds);
/// Returns the state as JSON: {"state", "is_running", "is_frozen": whether the client is in the call that does not
/// return, "sessions", "frames_ended", "api_minor": minor version of OpenXR 1 that the client asked for, or null
/// without an instance, "client_errors": [text], "client_warnings": [text], "haptics": [...], "calls": {name: count},
/// "last_frame": {"blend_mode", "layers": [...], ...}}.
const char* fettle_xr_report();

/// The picture of an eye: 4 bytes of red, green, blue and alpha per pixel, sRGB, the top row first, without gaps. Alpha
/// has no meaning: the real room is in the picture already, if it is to be seen.
struct FettleXrPicture
{
    int width, height;
    const std::uint8_t* rgba;
};
/// Returns the newest picture of the left eye since the last call, or null, and requests the next one. Does not wait.
/// The picture stays valid until the thread's next call.
const FettleXrPicture* fettle_xr_picture();
}
