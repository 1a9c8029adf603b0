"""`python -m roam_core`: the command line without the window."""

import sys

from roam_core.cli.program import command

sys.exit(command(sys.argv[1:]))
