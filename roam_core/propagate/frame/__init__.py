"""What every engine needs of one frame: its result, curves laid along a region, confidence, re-detection."""
