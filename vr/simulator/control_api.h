#pragma once

#include <cstdint>

// clang-format off
/// How the runtime is steered: by a script that the environment names, or in the client's process through the functions
/// below, found by dlsym() in the library, by a test or by the simulator's window. All speak JSON with one vocabulary.
///
///     FETTLE_XR_SCRIPT    a file with a script; none: a headset that lies still
///     FETTLE_XR_LOG       a file that is written, an object a line: {"call", "result", "session", "frame", ...},
///                         {"ended_frame"}, {"haptic"}, {"client_error"}, {"client_warning"}
///     FETTLE_XR_FRAMES    a folder for pictures: session0_frame0012_left.png, _right, _mono, _quad0 ...
///
/// A script: {"start": STEP, "steps": [STEP with "frame": n and perhaps "session": n, ...]}. Frames count from 0 in
/// each session, sessions in each process; a step without "session" is of the first. A step happens when the client
/// waits for its frame, which sees it first. The display time moves by exactly one period a frame, so that a run is the
/// same every time. Nothing hindering, a session shall render from frame 2 on and has the focus from frame 3 on. In a
/// STEP, all optional:
///
///     "over": n                     movements of this step take n frames instead of happening at once
///     "head": {"position": [x,y,z], "rotation": [x,y,z,w] or "yaw_pitch_roll": [degrees],
///         "tracked": true|false|"rotation"|"no_position"}
///     "left", "right": as head, and "on", "trigger", "squeeze", "pad": [x,y], "pad_touch", "pad_press",
///         "stick": [x,y], "stick_press", "menu", "button_a", "button_b": numbers, or true and false
///     "aim": {"position", "rotation"}   where wands point, as seen from their grips
///     "profile": path               which kind of wands they are
///     "size": [w,h], "eye_distance", "views": "stereo"|"mono"|"mono_first"
///     "fov": [left,right,up,down]   degrees, of the left eye
///     "hidden": share               of a picture's sides, at each corner, which the lens hides
///     "hz", "rates": [hz]           the display's rate, and others that it can have
///     "stage": bool, "local_floor": bool, "bounds": [w,d]|null
///     "runtime", "headset", "opengl": bool   whether there is one, for who asks next
///     "extensions": bool            whether those are offered that no client needs
///     "least_opengl": [major,minor]
///     "pace": "real"|"live"|"fast"|"stepped"   live: the display time is the clock's, else a slow client has slow time
///     "worn", "visible", "focus", "should_render": bool
///     "exit": true                  the session is asked to stop for good
///     "late_ms": n                  the frame comes so much later, and its display time as many periods
///     "recentre": {"space": "local"|"stage", "position", "rotation", "after": n}   the space's new origin in the room
///     "lose_session": n, "lose_instance": n   foretold now, lost n frames later
///     "lose_events": true           those that wait, but for a session's states
///     "fail": {"call": name, "result": XrResult's name, "times": n, "after": n}   answers in the call's stead, once
///                               so many calls have been answered
///     "freeze": name                that call does not return until another is named, or ""
///     "wake_at_exit": true          or until the process ends by exit(), which then gives it a moment
///     "keep": true|[frames], "keep_every": n   whose pictures are kept; true: of the next frame
///     "watch_drawing": bool         a swapchain that goes while its images are still drawn on is the client's error
///
/// Poses are in the room: metres, Y up, the floor at y = 0. A wand's pose is its grip.
/// Any thread may call these; a text stays valid until the thread's next call.
// clang-format on
extern "C" {
/// Begins anew with that script; the environment's log and folder are opened again. Null, or what is wrong.
const char* fettle_xr_load(const char* script);
/// Does a step now: the next frame sees it. Null, or what is wrong.
const char* fettle_xr_do(const char* step);
/// Waits until so many more frames have ended, which pace "stepped" lets go, and the client waits for the next or has
/// stopped. Returns how many ended, which is less if that takes longer than it may.
int fettle_xr_frames(int count, int milliseconds);
/// {"state", "is_running", "is_frozen": the client is in the call that does not return, "sessions", "frames_ended",
/// "api_minor": of OpenXR 1, as the client asked for it; null without an instance,
/// "client_errors": [text], "client_warnings": [text], "haptics": [...], "calls": {name: count}, "last_frame":
/// {"layers": [...], ...}}
const char* fettle_xr_report();

/// What an eye sees: 4 bytes of red, green, blue and alpha a pixel, the top row first, without gaps; sRGB. Alpha says
/// nothing.
struct FettleXrPicture
{
    int width, height;
    const std::uint8_t* rgba;
};
/// The newest of the left eye since the last call, or null; and asks for the next. Returns at once. It stays valid
/// until the thread's next call.
const FettleXrPicture* fettle_xr_picture();
}
