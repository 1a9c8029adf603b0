"""The shell: the main window and what starts it; it builds the parts and connects them."""
