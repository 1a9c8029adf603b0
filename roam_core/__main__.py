"""`python -m roam_core`: the command line without the window."""

import sys

from roam_core.cli import main
from roam_core.cli.environment import decoding_apart

with decoding_apart():
    status = main()
sys.exit(status)
