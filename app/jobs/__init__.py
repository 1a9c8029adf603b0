"""Long work off the window's thread: decoding, tracking, exports, saving."""
