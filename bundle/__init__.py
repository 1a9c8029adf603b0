"""The stand-alone bundle: ROAM with an interpreter, its libraries and compiled kernels in one folder."""
