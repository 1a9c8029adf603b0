"""`python -m roam_core`: the command line without the window."""

import sys

from roam_core.cli.program import command_as_process

sys.exit(command_as_process(sys.argv[1:]))
