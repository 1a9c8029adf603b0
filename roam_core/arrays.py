"""Types of arrays, by what lies in them; what their axes mean is said where they are used."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
"""Places, lengths and energies."""
Float32 = NDArray[np.float32]
"""Fields over cells: log-ratios, coverage, flow."""
Bools = NDArray[np.bool_]
UInt8 = NDArray[np.uint8]
"""Pictures of 8 bits, and marks of cells."""
UInt16 = NDArray[np.uint16]
"""What is counted from those, in whole numbers: squares, slopes."""
Int32 = NDArray[np.int32]
Int64 = NDArray[np.int64]
Indices = NDArray[np.intp]
"""Places in other arrays."""
Image = NDArray[Any]
"""A picture `(h, w, 3)`, RGB: uint8 or float32; of a plate, as its files hold it, also uint16 or float16. The largest
integer is white; of floating point 1.0 is, and scene-linear values may lie above."""
Matte = Float32
"""Coverage `(h, w)` in [0, 1]."""
