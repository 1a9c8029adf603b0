"""SVG: drawings that any renderer shows as our matte, out; drawings of any program, in."""
