"""What other programs say to a window: its window manager, and one from which files are dragged.
xdotool has no words for it."""

import ctypes
import ctypes.util
import select
import time


class ClientMessage(ctypes.Structure):
    """A message from one X client to another, as large as the union XEvent."""

    TYPE = 33

    _fields_ = [("type", ctypes.c_int), ("serial", ctypes.c_ulong), ("send_event", ctypes.c_int),
                ("display", ctypes.c_void_p), ("window", ctypes.c_ulong),
                ("message_type", ctypes.c_ulong), ("format", ctypes.c_int),
                ("data", ctypes.c_long * 5), ("rest", ctypes.c_long * 24)]


class SelectionEvent(ctypes.Structure):
    """A client asks for a selection (with an owner), or is told that it is there (without)."""

    REQUEST, NOTIFY = 30, 31

    _fields_ = [("type", ctypes.c_int), ("serial", ctypes.c_ulong), ("send_event", ctypes.c_int),
                ("display", ctypes.c_void_p), ("windows_and_atoms", ctypes.c_ulong * 6),
                ("rest", ctypes.c_long * 24)]


class Connection:
    """One X client."""

    def __init__(self, display):
        self._x11 = ctypes.CDLL(ctypes.util.find_library("X11"))
        pointer, number, whole = ctypes.c_void_p, ctypes.c_ulong, ctypes.c_int
        for name, result, *arguments in (
                ("XOpenDisplay", pointer, ctypes.c_char_p),
                ("XDefaultRootWindow", number, pointer),
                ("XCreateSimpleWindow", number, pointer, number, whole, whole, whole, whole, whole,
                 number, number),
                ("XInternAtom", number, pointer, ctypes.c_char_p, whole),
                ("XSelectInput", whole, pointer, number, ctypes.c_long),
                ("XSetSelectionOwner", whole, pointer, number, number, number),
                ("XChangeProperty", whole, pointer, number, number, number, whole, whole,
                 ctypes.c_char_p, whole),
                ("XSendEvent", whole, pointer, number, whole, ctypes.c_long, pointer),
                ("XFlush", whole, pointer), ("XPending", whole, pointer),
                ("XConnectionNumber", whole, pointer),
                ("XNextEvent", whole, pointer, pointer), ("XCloseDisplay", whole, pointer)):
            function = getattr(self._x11, name)
            function.restype, function.argtypes = result, arguments
        # By itself Xlib ends the whole script where a window is gone.
        self._forgive = ctypes.CFUNCTYPE(whole, pointer, pointer)(lambda display, fault: 0)
        self._x11.XSetErrorHandler(self._forgive)
        self._display = self._x11.XOpenDisplay(display.encode())
        self._root = self._x11.XDefaultRootWindow(self._display)

    def close(self):
        self._x11.XCloseDisplay(self._display)

    def _atom(self, name):
        return self._x11.XInternAtom(self._display, name, 0)

    def _send(self, window, kind, *data):
        event = ClientMessage(type=ClientMessage.TYPE, window=window, format=32)
        event.message_type = self._atom(kind)
        event.data[:len(data)] = data
        self._deliver(window, event)

    def _deliver(self, window, event):
        self._x11.XSendEvent(self._display, window, 0, 0, ctypes.byref(event))
        self._x11.XFlush(self._display)

    def _news(self):
        """The messages since the last call, whatever they are."""
        while self._x11.XPending(self._display):
            event = ClientMessage()
            self._x11.XNextEvent(self._display, ctypes.byref(event))
            yield event


class WindowManager(Connection):
    """What a window manager says to a window."""

    _SUBSTRUCTURE_NOTIFY = 1 << 19  # who selects it on the root window hears the answers

    def __init__(self, display):
        super().__init__(display)
        self._x11.XSelectInput(self._display, self._root, self._SUBSTRUCTURE_NOTIFY)
        self._pings = 0

    def ask_to_close(self, window):
        """Does what the cross in a title bar does."""
        self._send(window, b"WM_PROTOCOLS", self._atom(b"WM_DELETE_WINDOW"))

    def ping(self, window):
        """Asks a window whether it is there; returns the question, for `heard`."""
        self._pings += 1
        self._send(window, b"WM_PROTOCOLS", self._atom(b"_NET_WM_PING"), self._pings, window)
        return self._pings

    def heard(self, question):
        """Whether the answer is among the news since the last call."""
        return any([event.type == ClientMessage.TYPE and event.data[1] == question
                    for event in self._news()])


class FileDrag(Connection):
    """A file manager with files in its hand: the source's side of the protocol XDND."""

    _VERSION = 5
    _NOW = 0  # CurrentTime
    _REPLACE, _BYTES = 0, 8

    def __init__(self, display, paths):
        super().__init__(display)
        self._files = "".join(f"{path.as_uri()}\r\n" for path in paths).encode()
        self._own = self._x11.XCreateSimpleWindow(self._display, self._root, 0, 0, 1, 1, 0, 0, 0)
        self._x11.XSetSelectionOwner(self._display, self._atom(b"XdndSelection"), self._own,
                                     self._NOW)

    def drop_on(self, window, x, y, patience):
        """Enters a window, moves to a place of the screen and lets go, as far as the window lets."""
        kind, copy = self._atom(b"text/uri-list"), self._atom(b"XdndActionCopy")
        self._send(window, b"XdndEnter", self._own, self._VERSION << 24, kind)
        self._send(window, b"XdndPosition", self._own, 0, x << 16 | y, self._NOW, copy)
        accepted = self._answer(b"XdndStatus", patience).data[1] & 1
        if not accepted:
            raise AssertionError("the window does not take files")
        self._send(window, b"XdndDrop", self._own, 0, self._NOW)
        self._answer(b"XdndFinished", patience)

    def _answer(self, kind, patience):
        """Waits for an answer, and meanwhile hands over the files where they are asked for."""
        end = time.monotonic() + patience
        while time.monotonic() < end:
            for event in self._news():
                if event.type == ClientMessage.TYPE and event.message_type == self._atom(kind):
                    return event
                if event.type == SelectionEvent.REQUEST:
                    self._hand_over(SelectionEvent.from_buffer_copy(event))
            select.select([self._x11.XConnectionNumber(self._display)], [], [], 0.1)
        raise AssertionError(f"no {kind.decode()} within {patience} s")

    def _hand_over(self, request):
        _, requestor, selection, target, where, moment = request.windows_and_atoms
        self._x11.XChangeProperty(self._display, requestor, where, target, self._BYTES,
                                  self._REPLACE, self._files, len(self._files))
        notice = SelectionEvent(type=SelectionEvent.NOTIFY)
        notice.windows_and_atoms[:5] = requestor, selection, target, where, moment
        self._deliver(requestor, notice)
