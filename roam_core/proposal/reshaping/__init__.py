"""Where a segmentation and a curve differ markedly: nodes displaced, inserted, removed; a shape made two."""
