"""Recordings of an arm: written while it moves, read again, compared with an arm, and replayed on it.

A recording is an MCAP file of ROS 2 messages (CDR). Foxglove, PlotJuggler and `ros2 bag play` read it without a plugin,
`rosbags` knows all of its messages, and the bags of other programs consist of the same messages: one encoding serves
for writing and for reading. Its records are written one after another, without chunks. What is on the disk is therefore
readable up to the last whole record, whenever the writing program ends.
"""
