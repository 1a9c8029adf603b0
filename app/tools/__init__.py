"""The tools of the canvas, one a file; `toolbox` knows them by name."""
