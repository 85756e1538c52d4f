"""The lab: the server, the seats, the windows, and the workcells with their clock.

There are two threads. The clock's thread only moves the arms. The server's event loop takes requests and updates the
windows. They share the workcells: the loop puts updates into the inbox of a workcell and reads its state, which is
immutable and is replaced as a whole.
"""
