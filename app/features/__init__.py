"""What an artist does with the parts below: tracking, proposals, playback, going through time."""
