"""What compiled blocks call: the standard functions and function blocks, for speed.

Nothing here is shared with the reference evaluator, so that the two can be compared. A function
that cannot go on raises `stops.Stop`; where in the PLC text that was, the caller's line tells.
"""
