"""What every engine needs of one frame: its result, curves fitted to a region, confidence, re-detection."""
