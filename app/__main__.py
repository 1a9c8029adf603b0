"""`python -m app`: the same as `roam`."""

import sys

from roam_core.cli.program import main

if __name__ == "__main__":
    sys.exit(main())
