"""Jobs of reviewing: what is written for others to look at."""
