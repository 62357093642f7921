#include "tests/support/other_windows_x11.h"

#include <memory>
#include <vector>

#include <X11/Xatom.h>
#include <X11/Xlib.h>

namespace
{
template <class T> std::unique_ptr<T, int (*)(void*)> owned(T* data)
{
    return {data, XFree};
}

std::vector<Window> childrenOf(Display* display, Window window)
{
    Window root = 0, parent = 0, *children = nullptr;
    unsigned int count = 0;
    if (!XQueryTree(display, window, &root, &parent, &children, &count))
        return {};
    const auto list = owned(children);
    return {children, children + count};
}

/// Returns the id of the process that owns the window, or 0 if the window does not report it.
qint64 processOf(Display* display, Window window)
{
    const Atom name = XInternAtom(display, "_NET_WM_PID", False);
    Atom type = 0;
    int format = 0;
    unsigned long count = 0, rest = 0;
    unsigned char* data = nullptr;
    XGetWindowProperty(display, window, name, 0, 1, False, XA_CARDINAL, &type, &format, &count, &rest, &data);
    const auto value = owned(data);
    return data && count == 1 ? static_cast<qint64>(*reinterpret_cast<const unsigned long*>(data)) : 0;
}

bool isSeen(Display* display, Window window)
{
    XWindowAttributes attributes{};
    return XGetWindowAttributes(display, window, &attributes) && attributes.map_state == IsViewable;
}

void askToClose(Display* display, Window window)
{
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = window;
    event.xclient.message_type = XInternAtom(display, "WM_PROTOCOLS", False);
    event.xclient.format = 32;
    event.xclient.data.l[0] = static_cast<long>(XInternAtom(display, "WM_DELETE_WINDOW", False));
    XSendEvent(display, window, False, NoEventMask, &event);
}

int askToClose(Display* display, Window parent, qint64 process)
{
    int asked = 0;
    for (const Window window : childrenOf(display, parent)) {
        if (processOf(display, window) == process && isSeen(display, window)) {
            askToClose(display, window);
            ++asked;
        }
        asked += askToClose(display, window, process);
    }
    return asked;
}
} // namespace

bool askToClose(qint64 process)
{
    // ignores errors of windows that close meanwhile
    const auto before = XSetErrorHandler([](Display*, XErrorEvent*) { return 0; });
    Display* display = XOpenDisplay(nullptr);
    const bool hasAsked = display && askToClose(display, DefaultRootWindow(display), process) > 0;
    if (display)
        XCloseDisplay(display);
    XSetErrorHandler(before);
    return hasAsked;
}
