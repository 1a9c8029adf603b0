"""What the window works on: the document with its undo, what is shown and selected, what the artist prefers."""
