"""Hours of the real application, not part of the suite: killed at any moment, and worked with on and on.

    python -m tests.endurance kill --times 200
    python -m tests.endurance soak --minutes 60

`docs/RELIABILITY.md` tells what came out.
"""
