"""Time, seen: the transport, the ruler with its playhead, the rows of keys, the confidence plot."""
