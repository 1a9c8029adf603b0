"""The journal of edits: what the artist did since the last save, on the disk at once, and how it comes back."""
