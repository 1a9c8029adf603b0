"""MLT's rotoscoping filter (Kdenlive, Shotcut): its splines, out and in."""
