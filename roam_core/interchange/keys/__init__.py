"""Which keys leave and come in: as few as hold a tolerance, smoothed through time, sampled where they must be."""
