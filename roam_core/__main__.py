"""`python -m roam_core`: the command line without the window."""

import sys

from roam_core.cli import main

sys.exit(main())
