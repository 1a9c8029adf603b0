"""`python -m app`: the same as `roam`."""

import sys

from app.shell.launch import main

if __name__ == "__main__":
    sys.exit(main())
