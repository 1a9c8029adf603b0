"""`python -m roam_core.media.first_picture MOVIE` decodes the first picture of a movie, and does nothing with it.

What FFmpeg cannot convert it writes to the output of the process; OpenCV tells nobody. So somebody who wants to know
runs this as a process of its own and listens (`roam_core.media.interlacing`).
"""

from __future__ import annotations

import sys

import cv2

if __name__ == "__main__":
    cv2.VideoCapture(sys.argv[1], cv2.CAP_FFMPEG).read()
