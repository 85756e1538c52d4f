"""The lab: the server, the seats, the windows, and the workcells with their clock.

Two threads: the clock's moves the arms, and nothing else runs in it; the server's event loop hears, draws and writes.
They meet in a workcell: the loop puts wishes into its inbox, and reads its state, which is never changed but replaced.
"""
